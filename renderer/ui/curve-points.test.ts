import { describe, expect, test } from '@jest/globals';
import { curvePath, withoutPoint, withPoint, withPointAt, withPointInGap } from './curve-points.ts';

const BOW = [0, 0, 0.25, 0.5, 1, 1];
const FULL = Array.from({ length: 16 }, (_, i) => (i % 2 === 0 ? i / 14 : 0.5));

describe('a point', () => {
  test('is added on the line, and leaves the ends where they are', () => {
    expect(withPoint([0, 0, 1, 1], 0.3)).toEqual({ curve: [0, 0, 0.3, 0.3, 1, 1], index: 1 });
    expect(withPoint([0.2, 0.4, 1, 1], 0.1)).toEqual({ curve: [0.1, 0.4, 0.2, 0.4, 1, 1], index: 0 });
  });

  test('is refused on another one, outside, and where there are eight', () => {
    expect([withPoint(BOW, 0.25), withPoint(BOW, 0.2504), withPoint(BOW, 1.01), withPoint(FULL, 0.03)]).toEqual([null, null, null, null]);
  });

  test('is added in the widest gap when nobody says where', () => {
    expect(withPointInGap(BOW)?.index).toBe(2);
    expect(withPointInGap([0.9, 0, 1, 1])?.curve.slice(0, 2)).toEqual([0.45, 0]);
    expect(withPointInGap(FULL)).toBeNull();
  });

  test('goes as far as its neighbors and the square let it', () => {
    expect(withPointAt(BOW, 1, { x: 2, y: 3 })).toEqual([0, 0, 0.999, 1, 1, 1]);
    expect(withPointAt(BOW, 1, { x: -1, y: -1 })).toEqual([0, 0, 0.001, 0, 1, 1]);
    expect(withPointAt(BOW, 0, { x: -1, y: 0.12345 })).toEqual([0, 0.123, 0.25, 0.5, 1, 1]);
    expect(withPointAt(BOW, 2, { x: 0, y: 1 })).toEqual([0, 0, 0.25, 0.5, 0.251, 1]);
  });

  test('is taken away, but the last two stay', () => {
    expect(withoutPoint(BOW, 1)).toEqual([0, 0, 1, 1]);
    expect(withoutPoint([0, 0, 1, 1], 0)).toEqual([0, 0, 1, 1]);
  });
});

test('the drawn curve is the computed one: level outside, and between points a Bézier curve with the slopes at a third', () => {
  expect(curvePath([0, 0, 1, 1])).toBe('M0 1H0C0.3333 0.6667 0.6667 0.3333 1 0H1');
  // The parabola through all three is (2 · 0.2 + 0.3) · 5 / 0.5 = 7 steep at the first, which is level at the second.
  expect(curvePath([0.2, 0, 0.4, 1, 0.7, 1])).toBe('M0 1H0.2C0.2667 0.5333 0.3333 0 0.4 0C0.5 0 0.6 0 0.7 0H1');
});
