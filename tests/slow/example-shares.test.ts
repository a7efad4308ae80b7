import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { decodeImage } from '../support/image.ts';
import { succeed } from '../support/scrim.ts';

const EXAMPLES = resolve(import.meta.dirname, '../../examples');
/** A quarter of the gallery's size: the shares of areas stay the same. */
const SIZE = '320x240';
/** An alpha that one can see. */
const SEEN = 25;

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-shares-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** Whether each pixel of a layer is visible, in the view of the gallery. */
async function seen(project: string, layer: string): Promise<readonly boolean[]> {
  const out = join(base, `${layer}.png`);
  await succeed('render', project, '--session', join(EXAMPLES, 'sessions/studio'), '--size', SIZE, '--layer', layer, '--out', out);
  const { width, height, data } = decodeImage(await readFile(out));
  return Array.from({ length: width * height }, (_, i) => (data[4 * i + 3] ?? 0) > SEEN);
}

const share = (pixels: readonly boolean[]) => pixels.filter((isIn) => isIn).length / pixels.length;

test.each([
  ['gooch-tones', 'scene-f12a.layer'],
  ['built-of-bricks', 'scene-f12b.layer'],
  ['pen-strokes', 'scene-f12c.layer'],
])('the style of %s fills a third of the image', async (example, layer) => {
  expect(share(await seen(join(EXAMPLES, example), layer))).toBeGreaterThan(1 / 3);
});

test('the book and its lectern fill a third of the image', async () => {
  expect(share(await seen(join(EXAMPLES, 'the-world-in-the-book'), 'reading-f13.layer'))).toBeGreaterThan(1 / 3);
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
  const [models, shadows] = [await seen(project, 'scene-f11.layer'), await seen(project, 'shadow-f11.layer')];
  expect(share(shadows.map((isIn, i) => isIn && !models[i]))).toBeGreaterThan(1 / 3);
});
