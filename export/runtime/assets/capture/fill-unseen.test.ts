import { expect, test } from '@jest/globals';
import { workAtOnce } from '../../gl/spread-work.ts';
import { fillUnseen } from './fill-unseen.ts';

const SIDE = 90;

/** The triangles of a grid of vertices. */
const GRID = Uint32Array.from(
  Array.from({ length: (SIDE - 1) ** 2 }, (_, i) => Math.floor(i / (SIDE - 1)) * SIDE + (i % (SIDE - 1))).flatMap((a) => [
    ...[a, a + 1, a + SIDE],
    ...[a + 1, a + SIDE + 1, a + SIDE],
  ]),
);

/** As its doc says, one ring after the other over all triangles. */
function byRings(colors: Uint8Array, indices: Uint32Array): void {
  for (let ring = 0; ring < 64; ring++) {
    const sums = new Float64Array(colors.length);
    for (let i = 0; i < indices.length; i++) {
      const to = 4 * (indices[i] ?? 0);
      if (colors[to + 3] !== 0) continue;
      const first = i - (i % 3);
      for (const corner of indices.subarray(first, first + 3)) {
        if (colors[4 * corner + 3] === 0) continue;
        for (let c = 0; c < 4; c++) sums[to + c] = (sums[to + c] ?? 0) + (c === 3 ? 1 : (colors[4 * corner + c] ?? 0));
      }
    }
    sums.forEach((sum, at) => {
      const weight = sums[at - (at % 4) + 3] ?? 0;
      if (weight > 0) colors[at] = at % 4 === 3 ? 255 : Math.round(sum / weight);
    });
  }
  colors.forEach((_, at) => {
    if (at % 4 === 0 && colors[at + 3] === 0) colors.set([128, 128, 128, 255], at);
  });
}

/** Colors of a grid, of which a part is unseen. */
function colorsWithout(isUnseen: (x: number, y: number) => boolean): Uint8Array {
  return Uint8Array.from({ length: 4 * SIDE * SIDE }, (_, i) => {
    const [x, y] = [Math.floor(i / 4) % SIDE, Math.floor(i / 4 / SIDE)];
    if (isUnseen(x, y)) return 0;
    return i % 4 === 3 ? 255 : (x * 7 + y * 13 + (i % 4) * 50) % 256;
  });
}

test.each([
  ['nothing', () => false],
  ['single vertices', (x: number, y: number) => (x * 31 + y * 17) % 11 === 0],
  ['a block in the middle', (x: number, y: number) => Math.hypot(x - 40, y - 50) < 30],
  ['more than 64 rings at an edge', (_: number, y: number) => y > 10],
  ['everything', () => true],
])('where %s is unseen, each ring has the mean of what is beside it', (_, isUnseen) => {
  const expected = colorsWithout(isUnseen);
  byRings(expected, GRID);
  const filled = colorsWithout(isUnseen);
  workAtOnce(fillUnseen(filled, GRID));
  expect(Buffer.from(filled).equals(Buffer.from(expected))).toBe(true);
});
