import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { chooseOption } from '../support/choose-option.ts';
import { EditorDriver, FLAG_PX } from '../support/editor-driver.ts';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import { countDifferent, expectSamePixels } from '../support/pixels.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { openXrPage } from '../xr/xr-page.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const chromium = useBrowser();

/** Where the preview's walk begins: see `renderer/preview/walk.ts`. */
const START_PITCH_RAD = -0.15;
const START = { position: [0, 1.5, 1], quaternion: [Math.sin(START_PITCH_RAD / 2), 0, 0, Math.cos(START_PITCH_RAD / 2)] } as const;
/** Frames after the first; the page draws as many when it enters. */
const STEPS = 2;
/** A fifteenth of a second, in which the model moves. */
const LATER_STEPS = 4;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-parity-'));
});
afterAll(async () => {
  for (const served of exported.values()) await served.close();
  await rm(base, { recursive: true, force: true });
});

/** Pages by their project. Compression rounds what a model is made of; what is compared here is how it is played. */
const exported = new Map<string, ServedExport>();
async function pageUrlOf(project: string): Promise<string> {
  const served = exported.get(project) ?? (await serveProject(project, { compress: false }));
  exported.set(project, served);
  return served.url;
}

/** The example by itself has a filter over everything; without it, its layers go straight to the device. */
async function copyExample(forward: boolean): Promise<string> {
  const project = join(base, forward ? 'forward' : 'filtered');
  if (exported.has(project)) return project;
  await cp(join(ROOT, 'examples/first-light'), project, { recursive: true });
  if (!forward) return project;
  const file = join(project, 'project.scrim.json');
  const saved = JSON.parse(await readFile(file, 'utf8')) as {
    graphs: { main: { nodes: Record<string, { type: string; muted?: boolean }> } };
  };
  for (const node of Object.values(saved.graphs.main.nodes)) if (node.type === 'filter/color-temperature') node.muted = true;
  await writeFile(file, JSON.stringify(saved));
  return project;
}

/** What the running editor's preview shows in the studio, and at which size. */
async function previewOf(
  project: string,
  views: 1 | 2,
): Promise<{ readonly still: RgbaImage; readonly size: { width: number; height: number } }> {
  const server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: project, log: () => {} });
  const page = await chromium.browser.newPage({ viewport: { width: 1280, height: 800 } });
  const errors = collectErrors(page);
  await page.goto(server.invite());
  const editor = new EditorDriver(page);
  await editor.settled();
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await editor.press('Fit to panel');
  if (views === 2) await editor.press('Two views, as in a headset');
  await editor.settled();
  await editor.rewind();
  for (let i = 0; i < STEPS; i++) await editor.press('Next frame');
  const still = await editor.restingImage();
  const box = await page.locator('iframe[title="Preview"]').boundingBox();
  if (!box) throw new Error('There is no preview.');
  expect(errors).toEqual([]);
  await page.close();
  await server.close();
  return { still, size: { width: box.width, height: box.height } };
}

/** What the device of someone who visits the exported page shows, less what the page lays over it and the strip that the preview leaves out. */
async function pageOf(
  project: string,
  views: 1 | 2,
  size: { width: number; height: number },
): Promise<{ readonly first: RgbaImage; readonly later: RgbaImage }> {
  const options = {
    room: 'studio',
    device: views === 2 ? 'headset' : 'phone',
    views,
    sizePx: [size.width, size.height],
    antialias: true,
  } as const;
  const xr = await openXrPage(chromium.browser, await pageUrlOf(project), options, size);
  await xr.setPose(START);
  await xr.enter();
  await xr.page.getByRole('button', { name: 'Leave AR' }).evaluate((button) => {
    button.style.visibility = 'hidden';
  });
  const y = FLAG_PX;
  const screenshot = async () => decodeImage(await xr.page.screenshot({ clip: { x: 0, y, width: size.width, height: size.height - y } }));
  const first = await screenshot();
  await xr.step(LATER_STEPS);
  const later = await screenshot();
  expect(xr.errors).toEqual([]);
  await xr.close();
  return { first, later };
}

describe.each([
  // The page draws the layers and the filter by one shader (ADR 43).
  ['the example', false, 1, 1 / 10_000],
  ['the example in two views', false, 2, 1 / 10_000],
  ['layers drawn straight to the device', true, 1, 0],
] as const)('%s', (name, forward, views, mostDifferent) => {
  test('is the same in the running editor’s preview and in the served page, except where a fused pass rounds differently', async () => {
    const project = await copyExample(forward);
    const { still, size } = await previewOf(project, views);
    const { first, later } = await pageOf(project, views, size);
    await expectSamePixels(`parity-${name.replaceAll(' ', '-')}`, first, still, { tolerance: mostDifferent === 0 ? 0 : 1 });
    expect(countDifferent(first, still).pixels).toBeLessThanOrEqual(first.data.length * mostDifferent);
    // The comparison sees that the model moves.
    expect(countDifferent(later, still).pixels).toBeGreaterThan(100);
  });
});
