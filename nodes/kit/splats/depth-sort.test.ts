import { expect, test } from '@jest/globals';
import fc from 'fast-check';
import { createDepthSort } from './depth-sort.ts';
import { createRadixSort } from './radix-sort.ts';

test('sorts splats from far to near as a comparison does, and keeps the order of equal depths', () => {
  const number = fc.integer({ min: -1_000_000, max: 1_000_000 }).map((steps) => steps / 1024);
  fc.assert(
    fc.property(
      fc.array(fc.tuple(number, number, number), { minLength: 1, maxLength: 50 }),
      fc.tuple(number, number, number),
      (points, towards) => {
        const positions = Float32Array.from(points.flat());
        const direction = Float32Array.from(towards);
        const order = new Uint32Array(points.length);
        createDepthSort(positions).sort(direction, order);
        const depths = points.map((_, i) =>
          Math.fround([0, 1, 2].reduce((sum, axis) => sum + (direction[axis] ?? 0) * (positions[3 * i + axis] ?? 0), 0)),
        );
        const expected = [...depths.keys()].sort((a, b) => (depths[b] ?? 0) - (depths[a] ?? 0) || a - b);
        expect([...order]).toEqual(expected);
      },
    ),
  );
});

test('a second sort with the same memory gives its own result', () => {
  const sort = createRadixSort(4);
  const order = new Uint32Array(4);
  sort.keys.set([0xffffffff, 0, 2 ** 31, 5]);
  sort.into(order);
  expect([...order]).toEqual([1, 3, 2, 0]);
  sort.keys.set([3, 3, 1, 3]);
  sort.into(order);
  expect([...order]).toEqual([2, 0, 1, 3]);
});
