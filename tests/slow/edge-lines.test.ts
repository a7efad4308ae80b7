import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import { encodeImage, fromGl } from '../support/image.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Lines, Place } from './edge-lines.page.ts';

/** Lines of the edges of meshes against silhouettes that three.js draws; the images are kept in `tests/output/edge-lines`. */

const page = useModule('tests/slow/edge-lines.page.ts', { mounts: { '/models/': resolve('../shared/data/models') } });

const OUTPUT = 'tests/output/edge-lines';

async function drawn(name: string, ...[call, ...args]: readonly [string, ...unknown[]]): Promise<Lines> {
  const lines = await page.call<Lines>(call, ...args);
  mkdirSync(OUTPUT, { recursive: true });
  writeFileSync(`${OUTPUT}/${name}.png`, encodeImage(fromGl(480, 360, lines.pixels)));
  expect(lines.error).toBe(0);
  return lines;
}

const around = (azimuthRad: number): Place => ({ eye: [2.6 * Math.sin(azimuthRad), 0.5, 2.6 * Math.cos(azimuthRad)], target: [0, 0, 0] });
const FACE: Place = { eye: [0.1, 0.5, 1.3], target: [0, 0.25, 0] };

/** Left, right, top and bottom in pixels from the top left. */
const EYES_AND_MOUTH = [
  [169, 285, 172, 208],
  [195, 257, 262, 284],
] as const;

/** Pixels in the middle of 5 × 5 pixels of ink. */
function blotsIn(pixels: readonly number[], [left, right, top, bottom]: (typeof EYES_AND_MOUTH)[number]): number {
  const isInk = (x: number, y: number): boolean => (pixels[((359 - y) * 480 + x) * 4] ?? 255) < 150;
  let count = 0;
  for (let y = top; y < bottom; y++) {
    for (let x = left; x < right; x++) {
      let solid = true;
      for (let i = 0; i < 25 && solid; i++) solid = isInk(x - 2 + (i % 5), y - 2 + Math.floor(i / 5));
      if (solid) count++;
    }
  }
  return count;
}

describeWithData('lines of models', 'models', () => {
  test.each([
    ['LeePerrySmith.glb', FACE],
    ['Fox.glb', around(0.7)],
    ['RobotExpressive.glb', around(0.4)],
    ['BoomBox.glb', around(2.6)],
  ])('of %s are on its silhouettes, and nowhere else within its surfaces', async (file, place) => {
    const { silhouette, found, stray, ink } = await drawn(file, 'linesOf', `/models/${file}`, place, {});
    expect(silhouette).toBeGreaterThan(500);
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(stray / ink).toBeLessThan(0.002);
  });

  // Hulls pierce the closed lids and the corners of the mouth: there they draw 37 such pixels.
  test.each([0, 0.6])('leave no blots in the eyes and the mouth of a head, with suggestive contours of %d', async (suggestive) => {
    const { pixels } = await drawn(`face-${suggestive}`, 'linesOf', '/models/LeePerrySmith.glb', FACE, { suggestive });
    expect(EYES_AND_MOUTH.reduce((sum, box) => sum + blotsIn(pixels, box), 0)).toBeLessThan(4);
  });
});

describe('lines of simple shapes', () => {
  test('are at the creases of a box, and on no diagonal of its faces', async () => {
    const { silhouette, found, stray } = await drawn('box', 'linesOfShape', 'box', around(0.5), {});
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(stray).toBe(0);
  });

  test('are at the border of a sheet', async () => {
    const { silhouette, found, stray } = await drawn('sheet', 'linesOfShape', 'sheet', around(0.5), {});
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(stray).toBe(0);
  });

  test('are disposed with the geometry of the mesh', async () => {
    expect(await page.call<number>('leftBehind', around(0.5))).toBe(0);
  });
});
