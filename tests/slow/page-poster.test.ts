import { execFile } from 'node:child_process';
import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { drawPoster } from '../../app/cli/render/draw-poster.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { PosterFraming } from '../../nodes/kit/poster-framing.ts';
import { collectErrors, drawPageSeldom, useBrowser } from '../support/browser.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const PROJECT = join(ROOT, 'examples/first-light');

/** A sentence of the language that no type check of ours looks at. */
const REFUSED_SHADER = `/*{
  "INPUTS": [ { "NAME": "inputImage", "TYPE": "image" } ]
}*/
void main() {
  vec3 a = 1.0;
  gl_FragColor = vec4(a, 1.0);
}
`;

const chromium = useBrowser();
let served: ServedExport;
/** What the posters of the export frame. */
const framings: (PosterFraming | null)[] = [];
const exportedName = async () => (await readdir(served.folder)).find((file) => file.startsWith('poster-'));
beforeAll(async () => {
  served = await serveProject(PROJECT, {
    address: 'https://example.org/robots/',
    drawPoster: (program, framing) => {
      framings.push(framing);
      return drawPoster({ program, framing, projectRoot: PROJECT, installation: installationAt(ROOT, '0.0.0') });
    },
  });
});
afterAll(() => served.close());

/** The size, the number of colors and the number of red pixels of an image. */
async function colorsOf(url: string) {
  const page = await chromium.browser.newPage();
  await page.goto(url);
  const colors = await page.evaluate(() => {
    const image = document.querySelector('img');
    const canvas = new OffscreenCanvas(image?.naturalWidth ?? 0, image?.naturalHeight ?? 0);
    const context = canvas.getContext('2d');
    if (!image || !context) return null;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const seen = new Set<number>();
    let red = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [r = 0, g = 0, b = 0] = [data[i], data[i + 1], data[i + 2]];
      seen.add(((r >> 3) << 10) | ((g >> 3) << 5) | (b >> 3));
      // Robots are the only thing in the room that is as red as this.
      if (r > 120 && g < 60 && b < 60) red++;
    }
    return { width: canvas.width, height: canvas.height, seen: seen.size, red };
  });
  await page.close();
  return colors;
}

describe('the poster of a page', () => {
  test('is not drawn with a shader that a driver refuses: the export says which line', async () => {
    const base = await mkdtemp(join(tmpdir(), 'scrim-poster-'));
    try {
      const project = join(base, 'project');
      await cp(PROJECT, project, { recursive: true });
      const file = join(project, 'project.scrim.json');
      const text = await readFile(file, 'utf8');
      await mkdir(join(project, 'shaders'));
      await writeFile(join(project, 'shaders/edge.fs'), REFUSED_SHADER);
      const node = /"type": "filter\/color-temperature",\s*"version": 1,\s*"params": \{[^}]*\}/;
      await writeFile(file, text.replace(node, '"type": "filter/edge", "version": 1'));
      const out = join(base, 'page');
      const call = promisify(execFile)(process.execPath, [join(ROOT, 'bin/scrim.mjs'), 'export', project, '--out', out]);
      await expect(call).rejects.toMatchObject({ code: 1, stderr: expect.stringMatching(/shaders\/edge\.fs:5\b.* SCR042/) });
      expect(await readdir(base)).toEqual(['project']);
    } finally {
      await rm(base, { recursive: true, force: true });
    }
  });

  test('is a frame of it in a room, found by those who link to the page', async () => {
    const name = await exportedName();
    expect(name).toMatch(/\.jpg$/);
    const html = await readFile(join(served.folder, 'index.html'), 'utf8');
    expect(html).toContain(`<meta property="og:image" content="https://example.org/robots/${name}">`);
    const colors = await colorsOf(`${served.url}${name}`);
    expect(colors).toMatchObject({ width: 1200, height: 630 });
    expect(colors?.seen).toBeGreaterThan(500);
    expect(colors?.red).toBeGreaterThan(1000);
  });

  test('shows all objects, unless the project frames something else', async () => {
    const { program } = await compileProject(PROJECT, await readProjectFiles(PROJECT), () => ({
      sourceMaps: true,
      fuse: true,
      fold: true,
    }));
    if (program === null) throw new Error('The example does not compile.');
    // That of the example, which frames nothing.
    expect(framings).toEqual([null]);
    const exported = await colorsOf(`${served.url}${await exportedName()}`);
    const redOf = async (framing: PosterFraming) => {
      const poster = await drawPoster({ program, framing, projectRoot: PROJECT, installation: installationAt(ROOT, '0.0.0') });
      const colors = await colorsOf(`data:image/jpeg;base64,${Buffer.from(poster?.bytes ?? []).toString('base64')}`);
      expect(colors).toMatchObject({ width: 1200, height: 630 });
      return colors?.red ?? 0;
    };
    const whole = await redOf({ center: [0, 0], height: 100 });
    expect(whole).toBeGreaterThan(1000);
    expect(exported?.red).toBeGreaterThan(whole * 0.95);
    // The larger robot, at half the height of the view.
    expect(await redOf({ center: [-0.13, -0.05], height: 0.55 })).toBeGreaterThan(whole * 1.25);
    // The smaller robot, below what a poster in the middle of the view shows.
    expect(await redOf({ center: [0.4, -0.42], height: 0.35 })).toBeGreaterThan(whole * 1.25);
    const room = { name: 'studio', eye: [0, 1.5, 1], target: [0, 1.5, 2] } as const;
    expect(await redOf({ center: [0, 0], height: 0.5, room })).toBeLessThan(whole / 10);
  });

  test('is shown while the page loads, and gives way to the picture', async () => {
    const page = await chromium.browser.newPage({ viewport: { width: 1280, height: 720 } });
    const errors = collectErrors(page);
    let letThrough = () => {};
    const held = new Promise<void>((done) => {
      letThrough = done;
    });
    await page.route('**/assets/*', async (route) => {
      await held;
      await route.continue();
    });
    await drawPageSeldom(page);
    await page.goto(served.url);
    const poster = page.getByRole('img', { name: 'First light', exact: true });
    await poster.waitFor();
    await page.getByText(/^0\.\d of \d\.\d MB$|^\d+ of \d+ kB$/).waitFor();
    // On a phone it ends where the card begins, behind its round corners.
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForFunction(() => {
      const [image, card] = ['.poster', '.panel'].map((part) => document.querySelector(part)?.getBoundingClientRect());
      return image && card && Math.abs(image.bottom - card.top - 20) < 1;
    });
    await page.setViewportSize({ width: 1280, height: 720 });
    letThrough();
    await page.getByText('look around').waitFor();
    // Soft, behind the objects.
    await page.locator('.poster.soft').waitFor();
    expect(errors).toEqual([]);
    await page.close();
  });
});
