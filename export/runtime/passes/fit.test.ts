import { expect, test } from '@jest/globals';
import { fitted } from './fit.ts';

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
const FLIPPED = Float32Array.of(1, 0, 0, 0, -1, 0, 0, 1, 1);

/** Where a point of the view falls on the picture. */
function at(m: Float32Array, u: number, v: number): number[] {
  return [0, 1].map((row) => Number(((m[row] ?? 0) * u + (m[row + 3] ?? 0) * v + (m[row + 6] ?? 0)).toFixed(6)));
}

test('cover fills the view and cuts the longer side', () => {
  // A picture of 2:1 on a square view: its middle half is seen.
  const wide = fitted(UPRIGHT, 'cover', 200, 100, 50, 50);
  expect([at(wide, 0, 0), at(wide, 1, 1)]).toEqual([
    [0.25, 0],
    [0.75, 1],
  ]);
  const tall = fitted(UPRIGHT, 'cover', 100, 200, 50, 50);
  expect([at(tall, 0, 0), at(tall, 1, 1)]).toEqual([
    [0, 0.25],
    [1, 0.75],
  ]);
});

test('contain shows all of the picture, with room beside it', () => {
  const wide = fitted(UPRIGHT, 'contain', 200, 100, 50, 50);
  expect([at(wide, 0, 0.25), at(wide, 1, 0.75), at(wide, 0, 0)]).toEqual([
    [0, 0],
    [1, 1],
    [0, -0.5],
  ]);
  const tall = fitted(UPRIGHT, 'contain', 100, 200, 50, 50);
  expect([at(tall, 0.25, 0), at(tall, 0.75, 1)]).toEqual([
    [0, 0],
    [1, 1],
  ]);
});

test("the picture's own placement comes last", () => {
  const wide = fitted(FLIPPED, 'cover', 200, 100, 50, 50);
  expect([at(wide, 0, 0), at(wide, 1, 1)]).toEqual([
    [0.25, 1],
    [0.75, 0],
  ]);
});

test('stretch and pictures without a size stay as they are', () => {
  expect(fitted(FLIPPED, 'stretch', 200, 100, 50, 50)).toBe(FLIPPED);
  expect(fitted(FLIPPED, 'cover', 0, 0, 50, 50)).toBe(FLIPPED);
});
