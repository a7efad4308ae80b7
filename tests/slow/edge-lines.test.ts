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

type Box = readonly [left: number, right: number, top: number, bottom: number];

/** Whether a pixel from the top left is darker than a value. */
function isDarker(pixels: readonly number[], x: number, y: number, value: number): boolean {
  return (pixels[((359 - y) * 480 + x) * 4] ?? 255) < value;
}

/** Part of what is drawn in a box that is dark. */
function darkPart(pixels: readonly number[], [left, right, top, bottom]: Box): number {
  let dark = 0;
  let drawn = 0;
  for (let y = top; y < bottom; y++) {
    for (let x = left; x < right; x++) {
      if ((pixels[((359 - y) * 480 + x) * 4 + 3] ?? 0) < 100) continue;
      drawn++;
      if (isDarker(pixels, x, y, 110)) dark++;
    }
  }
  return dark / drawn;
}

/** Pixels in the middle of 5 × 5 pixels of ink. */
function blotsIn(pixels: readonly number[], [left, right, top, bottom]: Box): number {
  const isInk = (x: number, y: number): boolean => isDarker(pixels, x, y, 150);
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

/** Left, right, bottom and top of the pixels of ink, from the bottom left. */
function extentOf({ pixels }: Lines): readonly [number, number, number, number] {
  const extent: [number, number, number, number] = [480, 0, 360, 0];
  for (let i = 0; i < 480 * 360; i++) {
    if ((pixels[4 * i + 3] ?? 0) < 100 || (pixels[4 * i] ?? 255) > 110) continue;
    const [x, y] = [i % 480, Math.floor(i / 480)];
    extent[0] = Math.min(extent[0], x);
    extent[1] = Math.max(extent[1], x);
    extent[2] = Math.min(extent[2], y);
    extent[3] = Math.max(extent[3], y);
  }
  return extent;
}

/** Mean width in pixels of the upper and the lower line of the border of a sheet, at a share of their length. */
function widthAt(lines: Lines, share: number): number {
  const [left, right] = extentOf(lines);
  const columns = [share, 1 - share].map((part) => Math.round(left + part * (right - left)));
  let ink = 0;
  for (const x of columns)
    for (let y = 0; y < 360; y++) {
      const i = 4 * (y * 480 + x);
      if ((lines.pixels[i + 3] ?? 0) > 100 && (lines.pixels[i] ?? 255) < 110) ink++;
    }
  return ink / 4;
}

describe('strokes of the border of a sheet', () => {
  test('go beyond its corners by the overshoot', async () => {
    const [short, long] = [
      extentOf(await drawn('sheet', 'linesOfSheet', 2.4, {})),
      extentOf(await drawn('sheet-overshoot', 'linesOfSheet', 2.4, { overshootPx: 20 })),
    ];
    // The longest of three strokes goes all of it. Without, half the width of the line across goes beyond the corner.
    for (const [i, at] of short.entries()) expect(Math.abs(Math.abs((long[i] ?? 0) - at) + 4 - 20)).toBeLessThanOrEqual(3);
  });

  test('taper toward their ends', async () => {
    const even = await drawn('sheet', 'linesOfSheet', 2.4, {});
    const tapering = await drawn('sheet-taper', 'linesOfSheet', 2.4, { taper: 1 });
    expect(Math.abs(widthAt(even, 0.06) - widthAt(even, 0.5))).toBeLessThan(1);
    expect(widthAt(tapering, 0.06)).toBeLessThan(0.7 * widthAt(tapering, 0.5));
  });

  test('are thicker where the sheet is nearer, by the square root of the distance', async () => {
    const [near, far] = [
      widthAt(await drawn('sheet-near', 'linesOfSheet', 2, { depthWeight: 1 }), 0.5),
      widthAt(await drawn('sheet-far', 'linesOfSheet', 4, { depthWeight: 1 }), 0.5),
    ];
    expect(Math.abs(near / far - Math.SQRT2)).toBeLessThan(0.3);
  });

  test('are thinner in the light', async () => {
    const [shaded, lit] = [
      widthAt(await drawn('sheet', 'linesOfSheet', 2.4, {}), 0.5),
      widthAt(await drawn('sheet-light', 'linesOfSheet', 2.4, { lightWeight: 1 }), 0.5),
    ];
    expect(lit).toBeLessThan(0.85 * shaded);
  });
});

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

  test('of a head with 280,000 triangles are on its silhouettes, and leave no blots in the eyes and the mouth', async () => {
    const { silhouette, found, stray, ink, pixels } = await drawn('dense-face', 'linesOfDivided', '/models/LeePerrySmith.glb', FACE, {});
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(stray / ink).toBeLessThan(0.002);
    expect(EYES_AND_MOUTH.reduce((sum, box) => sum + blotsIn(pixels, box), 0)).toBeLessThan(4);
  });

  // The head of the camera has bellows, rails and knobs that are a few pixels apart. Strokes of their full width cover it: 97 % and 90 %.
  test.each([
    ['small', { eye: [1.5, 0.9, 3], target: [0, 0, 0] }, [222, 278, 95, 125]],
    ['large', { eye: [0.6, 0.75, 1.5], target: [-0.05, 0.7, 0] }, [225, 320, 170, 240]],
  ] as const)('do not blacken a %s model of many parts', async (name, place, box) => {
    const { silhouette, found, pixels } = await drawn(`camera-${name}`, 'linesOf', '/models/AntiqueCamera.glb', place, {});
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(darkPart(pixels, box)).toBeLessThan(0.6);
    expect(darkPart(pixels, box)).toBeGreaterThan(0.15);
  });
});

describe('lines of simple shapes', () => {
  test.each([0.4, 1.4])('of a dense knot are on its silhouettes and nowhere else, from %d rad', async (azimuthRad) => {
    const { silhouette, found, stray, pixels } = await drawn(`knot-${azimuthRad}`, 'linesOfShape', 'knot', around(azimuthRad), {});
    expect(silhouette).toBeGreaterThan(500);
    expect(found / silhouette).toBeGreaterThan(0.95);
    expect(stray).toBe(0);
    const { pixels: again } = await drawn(`knot-${azimuthRad}`, 'linesOfShape', 'knot', around(azimuthRad), {});
    expect(again).toEqual(pixels);
  });

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
