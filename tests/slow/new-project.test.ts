import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import { succeed } from '../support/scrim.ts';

const TEMPLATES = resolve(import.meta.dirname, '../../examples/templates');

let base = '';
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-new-'));
});
afterAll(() => rm(base, { recursive: true, force: true }));

/** The first frame of a new project, in the studio that comes with Scrim. */
async function draw(template: string): Promise<RgbaImage> {
  await succeed('new', join(base, template), '--template', template);
  await succeed('render', join(base, template), '--out', join(base, `${template}.png`));
  return decodeImage(await readFile(join(base, `${template}.png`)));
}

/** Of the pixels, how many pass. */
function share({ data }: RgbaImage, passes: (r: number, g: number, b: number, i: number) => boolean): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (passes(data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0, i)) count++;
  return count / (data.length / 4);
}

test('every template shows what it is called after, beside the bare picture of the room', async () => {
  const templates = await readdir(TEMPLATES);
  const pictures = Object.fromEntries(await inTurn(templates, async (name) => [name, await draw(name)] as const)) as Record<
    string,
    RgbaImage
  >;
  const { empty, filter, occlusion } = pictures;
  if (!empty || !filter || !occlusion) throw new Error('A template is missing.');
  expect(Object.keys(pictures).sort()).toEqual(['empty', 'filter', 'occlusion']);

  // The room as it was filmed has many hues; the drawing lies between ink, blue shade and cream paper.
  const green = (r: number, g: number, b: number) => g > r + 8 && g > b + 8;
  expect(share(empty, green)).toBeGreaterThan(0.1);
  expect(share(filter, green)).toBeLessThan(0.01);
  expect(share(filter, (r, g, b) => r + g + b < 150)).toBeGreaterThan(0.01);
  expect(share(filter, (r, g, b) => r > 200 && g > 190 && b > 160)).toBeGreaterThan(0.1);

  // The robot is a part of the image, red where the room is not, and its shadow darkens some of the floor beside it.
  const roomAt = (i: number) => [empty.data[i] ?? 0, empty.data[i + 1] ?? 0, empty.data[i + 2] ?? 0] as const;
  const changed = share(occlusion, (r, g, b, i) => {
    const [r0, g0, b0] = roomAt(i);
    return Math.abs(r - r0) + Math.abs(g - g0) + Math.abs(b - b0) > 30;
  });
  expect(changed).toBeGreaterThan(0.02);
  expect(changed).toBeLessThan(0.3);
  const red = (r: number, g: number, b: number) => r > 110 && g < 0.45 * r && b < 0.45 * r;
  expect(share(occlusion, red)).toBeGreaterThan(share(empty, red) + 0.005);
  const shadow = share(occlusion, (r, g, b, i) => {
    const [r0, g0, b0] = roomAt(i);
    const ratio = (r + g + b) / (r0 + g0 + b0 + 1);
    // Darker by the same factor in every color: the floor's own hue stays.
    return ratio < 0.8 && ratio > 0.3 && Math.abs(r / (r0 + 1) - g / (g0 + 1)) < 0.1;
  });
  expect(shadow).toBeGreaterThan(0.003);
});

async function inTurn<T, R>(items: readonly T[], task: (item: T) => Promise<R>): Promise<R[]> {
  const results: R[] = [];
  for (const item of items) results.push(await task(item));
  return results;
}
