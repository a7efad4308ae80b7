import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { playNewcomer } from '../../tools/newcomer/play-newcomer.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import type { RgbaImage } from '../support/image.ts';
import { PATIENCE_MS } from '../support/patience.ts';
import { countDifferent } from '../support/pixels.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const MODEL = join(ROOT, 'examples/first-light/assets/robot.glb');
const MOST_INTERACTIONS = 18;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-newcomer-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

const browser = useBrowser();

test('a newcomer makes a page with an occluded, shadowed cartoon in few interactions', async () => {
  const server = await startServer({ installation: installationAt(ROOT, '0.0.0'), startPath: null, log: () => {} });
  const page = await browser.browser.newPage({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });
  const errors = collectErrors(page);
  const [project, exportTo] = [join(base, 'first'), join(base, 'page')];
  try {
    await page.goto(server.invite());
    const done = await playNewcomer({ page, model: MODEL, project, exportTo });
    expect(done.length).toBeLessThanOrEqual(MOST_INTERACTIONS);

    // Each part is in the image: without it, the image is another one. The dialog of the export shows the page.
    await page.keyboard.press('Escape');
    await page.getByRole('dialog').waitFor({ state: 'detached' });
    const editor = new EditorDriver(page);
    await editor.settled();
    await editor.hold();
    await editor.press('Go to first frame');
    await page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '0');
    const whole = await imageThat(editor, (picture) => count(picture, isRed) > 200);
    /** Takes a part away, waits until the image shows that, and brings it back. */
    const without = async (stem: string, takeAway: () => Promise<void>, differs: (picture: RgbaImage) => boolean) => {
      await editor.node(stem).first().locator('.node-title').click();
      await takeAway();
      await imageThat(editor, differs);
      await page.keyboard.press('Control+z');
      await imageThat(editor, (picture) => countDifferent(picture, whole, 8).pixels < MOST_FLICKER);
    };
    const mute = () => page.keyboard.press('m');
    // In its own materials the robot has no dark outline.
    const isPlain = (picture: RgbaImage) => count(picture, isInk) < count(whole, isInk) && countDifferent(picture, whole, 24).pixels > 150;
    await without('apply', mute, isPlain);
    // The table hides the legs.
    await without(await occlusionOfScene(page, project), mute, (picture) => countDifferent(picture, whole, 24).pixels > 150);
    // A shadow only darkens.
    const fade = async () => {
      await editor.inspector.getByRole('textbox', { name: 'Strength' }).fill('0');
      await page.keyboard.press('Enter');
    };
    await without('shadow', fade, (picture) => darker(whole, picture) > 100 && darker(picture, whole) < MOST_FLICKER);
  } finally {
    await page.close();
    await server.close();
  }
  expect(errors).toEqual([]);
  await visitExportedPage(browser.browser, exportTo);
  const { features } = JSON.parse(await readFile(join(exportTo, 'report.json'), 'utf8'));
  expect(features.optional).toContain('depth-sensing');
});

/** Edges of hidden things may differ from one frame to the next by single pixels. */
const MOST_FLICKER = 30;

/** Waits for the image; fails where it does not come. */
async function imageThat(editor: EditorDriver, accept: (picture: RgbaImage) => boolean): Promise<RgbaImage> {
  const endMs = Date.now() + PATIENCE_MS;
  for (;;) {
    const picture = await editor.picture();
    if (accept(picture)) return picture;
    if (Date.now() > endMs) throw new Error(`The picture did not become what was waited for: ${accept}`);
  }
}

/** There are two: the one that hides the model, by the wires of the saved project. */
async function occlusionOfScene(page: Page, project: string): Promise<string> {
  await page.keyboard.press('Control+s');
  await page.locator('.unsaved').waitFor({ state: 'detached' });
  const found = /"scene-\w+\.layer -> (depth-occlusion-\w+)\.layer"/.exec(await readFile(join(project, 'project.scrim.json'), 'utf8'));
  if (found?.[1] === undefined) throw new Error('Nothing hides the scene.');
  return found[1];
}

type Passes = (red: number, green: number, blue: number) => boolean;
const isRed: Passes = (red, green, blue) => red > 110 && green < 0.45 * red && blue < 0.45 * red;
const isInk: Passes = (red, green, blue) => red + green + blue < 75;

function count({ data }: RgbaImage, passes: Passes): number {
  let found = 0;
  for (let i = 0; i < data.length; i += 4) if (passes(data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0)) found++;
  return found;
}

/** Pixels that are darker in the first, by more than rounding. */
function darker(a: RgbaImage, b: RgbaImage): number {
  const sum = ({ data }: RgbaImage, i: number) => (data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0);
  let found = 0;
  for (let i = 0; i < a.data.length; i += 4) if (sum(a, i) < sum(b, i) - 12) found++;
  return found;
}
