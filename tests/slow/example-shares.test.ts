import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { renderLayers } from '../support/render-layers.ts';

const EXAMPLES = resolve(import.meta.dirname, '../../examples');
/** A quarter of the gallery's size: the shares of areas stay the same. */
const [WIDTH, HEIGHT] = [320, 240];
/** An alpha that one can see. */
const SEEN = 25;

const chromium = useBrowser();
let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-shares-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** Whether each pixel of layers is visible, in the view of the gallery. */
async function seen(project: string, ...layers: readonly string[]): Promise<readonly (readonly boolean[])[]> {
  const session = join(EXAMPLES, 'sessions/studio');
  const images = await renderLayers(chromium.browser, { project, session, layers, frames: 1, widthPx: WIDTH, heightPx: HEIGHT });
  return layers.map((layer) => {
    const data = images.get(layer)?.[0]?.data ?? [];
    return Array.from({ length: WIDTH * HEIGHT }, (_, i) => (data[4 * i + 3] ?? 0) > SEEN);
  });
}

const share = (pixels: readonly boolean[]) => pixels.filter((isIn) => isIn).length / pixels.length;

test.each([
  ['gooch-tones', 'scene-f12a.layer'],
  ['built-of-bricks', 'scene-f12b.layer'],
  ['pen-strokes', 'scene-f12c.layer'],
])('the style of %s fills a third of the image', async (example, layer) => {
  const [style = []] = await seen(join(EXAMPLES, example), layer);
  expect(share(style)).toBeGreaterThan(1 / 3);
});

test('the book and its lectern fill a third of the image', async () => {
  const [book = []] = await seen(join(EXAMPLES, 'the-world-in-the-book'), 'reading-f13.layer');
  expect(share(book)).toBeGreaterThan(1 / 3);
});

test('sketched shadows fill a third of the image, beside the models', async () => {
  const project = join(base, 'sketchy-shadow');
  await cp(join(EXAMPLES, 'sketchy-shadow'), project, { recursive: true });
  const file = join(project, 'project.scrim.json');
  const text = await readFile(file, 'utf8');
  // Shadows as areas: strokes leave gaps.
  const even = text.replace('"drawing": "strokes"', '"drawing": "even"');
  expect(even).not.toBe(text);
  await writeFile(file, even);
  const [models = [], shadows = []] = await seen(project, 'scene-f11.layer', 'shadow-f11.layer');
  expect(share(shadows.map((isIn, i) => isIn && !models[i]))).toBeGreaterThan(1 / 3);
});
