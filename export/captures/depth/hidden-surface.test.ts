import { expect, test } from '@jest/globals';
import type { DepthMap } from './depth-map.ts';
import { panoramaRays, pinholeRays } from './depth-rays.ts';
import { hiddenSurface } from './hidden-surface.ts';

const SIZE = { widthPx: 640, heightPx: 60 };
const FOCAL_PX = 500;
const [LEFT, RIGHT] = [300, 420];
/** How far an eye that moves by 0.3 m sees behind an edge at 1 m before a wall at 2 m, and the most that is kept. */
const REACH_PX = 20;

/** A gray board at 1 m before a wall at 2 m, which is red on the left and blue on the right. */
function board(at: (column: number) => number) {
  const values = new Float32Array(SIZE.widthPx * SIZE.heightPx);
  const colors = new Uint8Array(4 * values.length);
  values.forEach((_, i) => {
    const column = at(i % SIZE.widthPx);
    const isBoard = column >= LEFT && column < RIGHT;
    values[i] = isBoard ? 1 : 2;
    // The edge itself has a mixed color, as in photographs.
    const isMixed = column === LEFT - 1 || column === RIGHT;
    colors.set(isBoard || isMixed ? [128, 128, 128, 255] : column < LEFT ? [200, 0, 0, 255] : [0, 0, 200, 255], 4 * i);
  });
  const map: DepthMap = { ...SIZE, values };
  return { map, colors };
}

const RAYS = pinholeRays({ ...SIZE, fxPx: FOCAL_PX, fyPx: FOCAL_PX, cxPx: 320, cyPx: 30 });

test('the wall goes on behind a board, in the colors of its two sides and never in those of the board', () => {
  const { map, colors } = board((column) => column);
  const hidden = hiddenSurface(map, RAYS, colors, FOCAL_PX);
  const row = 30 * SIZE.widthPx;
  const columns = [...Array(SIZE.widthPx).keys()].filter((column) => (hidden.map.values[row + column] ?? 0) > 0);
  // A pixel of the wall on each side, and the reach of an eye behind each edge.
  expect(columns.slice(0, REACH_PX + 1)).toEqual([...Array(REACH_PX + 1).keys()].map((i) => LEFT - 1 + i));
  expect(columns.slice(REACH_PX + 1)).toEqual([...Array(REACH_PX + 1).keys()].map((i) => RIGHT - REACH_PX + i));
  for (const column of columns) expect(hidden.map.values[row + column]).toBeCloseTo(2, 4);
  const color = (column: number) => [...hidden.colors.subarray(4 * (row + column), 4 * (row + column) + 3)];
  expect(color(LEFT + 10)).toEqual([200, 0, 0].map((value) => expect.closeTo(value, -1)));
  expect(color(RIGHT - 11)).toEqual([0, 0, 200].map((value) => expect.closeTo(value, -1)));
  expect(color(LEFT + 10)[2]).toBeLessThan(20);
});

test('nothing is hidden on an even wall, nor behind slanted surfaces', () => {
  const { colors } = board((column) => column);
  const values = Float32Array.from({ length: SIZE.widthPx * SIZE.heightPx }, (_, i) => 1 / (0.2 + 0.001 * (i % SIZE.widthPx)));
  expect(hiddenSurface({ ...SIZE, values }, RAYS, colors, FOCAL_PX).map.values.some((depth) => depth > 0)).toBe(false);
});

test('goes on over the left and right edges of a 360° photograph, and leaves its poles alone', () => {
  // The board stands behind the camera, in the first and last columns.
  const { map, colors } = board((column) => (column + 360) % 640);
  const { values } = hiddenSurface(map, panoramaRays(SIZE.widthPx, SIZE.heightPx), colors, FOCAL_PX).map;
  const row = 30 * SIZE.widthPx;
  expect([579, 580, 599, 600, 639].map((column) => (values[row + column] ?? 0) > 0)).toEqual([true, true, true, false, false]);
  expect(values.subarray(0, SIZE.widthPx).every((depth) => depth === 0)).toBe(true);
});
