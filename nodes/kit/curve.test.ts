import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { CURVE_NUMBERS, type Curve, curveAt, curveMisfit, DIAGONAL, MAX_CURVE_POINTS, paddedCurve, sampleCurve } from './curve.ts';

const PLACES = [0, 0.03, 0.11, 0.2, 0.333, 0.41, 0.5, 0.52, 0.7, 0.85, 0.93, 1];

/** `scipy.interpolate.PchipInterpolator(x, y)` of SciPy 1.17.1, asked at the places clamped to the range of `x`. */
const SCIPY: readonly (readonly [Curve, readonly number[]])[] = [
  [
    [0.1, 0.8, 0.9, 0.3],
    [0.8, 0.8, 0.79375, 0.7375, 0.654375, 0.60625, 0.55, 0.5375, 0.425, 0.33125, 0.3, 0.3],
  ],
  [
    [0, 0, 0.25, 0.1, 0.75, 0.9, 1, 1],
    [0, 0.0020736, 0.0247808, 0.0704, 0.186559704, 0.316832, 0.5, 0.541936, 0.856, 0.9568, 0.9893376, 1],
  ],
  [
    [0, 0, 0.3, 0.6, 1, 1],
    [
      0, 0.073222285714, 0.265475746032, 0.455746031746, 0.631346556455, 0.701547381924, 0.777259475219, 0.793002728863, 0.913096209913,
      0.977014577259, 0.994848, 1,
    ],
  ],
  [
    [0, 1, 0.2, 0.2, 0.5, 0.2, 0.55, 0.9, 1, 0.85],
    [1, 0.83002, 0.41546, 0.2, 0.2, 0.2, 0.2, 0.4464, 0.898148148148, 0.885185185185, 0.869891906722, 0.85],
  ],
  [
    [0.05, 0.5, 0.1, 0.9, 0.4, 0.1, 0.42, 0.12, 0.6, 0.7, 0.8, 0.65, 0.9, 1, 0.95, 0],
    [0.5, 0.5, 0.897392592593, 0.692592592593, 0.201883674074, 0.106653846154, 0.394914002321, 0.484573177166, 0.675, 0.825, 0.5524, 0],
  ],
  [
    [0, 0.9, 0.5, 0, 1, 0.2],
    [0.9, 0.8137956, 0.5944068, 0.3744, 0.1264041036, 0.0384588, 0, 1.28e-5, 0.0128, 0.0686, 0.1272112, 0.2],
  ],
  [
    [0, 0, 0.02, 0.9, 1, 1],
    [
      0, 0.902958402855, 0.924555100493, 0.944723143144, 0.967410790019, 0.977144439691, 0.985804641594, 0.987372039437, 0.996664990287,
      0.999499119943, 0.999929581964, 1,
    ],
  ],
];

const curves = fc
  .uniqueArray(fc.integer({ min: 0, max: 1000 }), { minLength: 2, maxLength: MAX_CURVE_POINTS })
  .chain((xs) =>
    fc
      .array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: xs.length, maxLength: xs.length })
      .map((ys): Curve => xs.sort((a, b) => a - b).flatMap((x, i) => [x / 1000, ys[i] ?? 0])),
  );

describe('a curve', () => {
  test.each(SCIPY)('%j is what SciPy makes of it', (curve, heights) => {
    heights.forEach((height, i) => {
      expect(curveAt(curve, PLACES[i] ?? 0)).toBeCloseTo(height, 11);
    });
  });

  test('goes through its points, and never beyond the two that it is between', () => {
    fc.assert(
      fc.property(curves, fc.double({ min: 0, max: 1, noNaN: true }), (curve, at) => {
        for (let i = 0; i + 3 < curve.length; i += 2) {
          const [x = 0, y = 0, nextX = 0, nextY = 0] = curve.slice(i, i + 4);
          expect(curveAt(curve, x)).toBeCloseTo(y, 12);
          expect(curveAt(curve, nextX)).toBeCloseTo(nextY, 12);
          const between = curveAt(curve, x + (nextX - x) * at);
          expect(between).toBeGreaterThanOrEqual(Math.min(y, nextY) - 1e-9);
          expect(between).toBeLessThanOrEqual(Math.max(y, nextY) + 1e-9);
        }
      }),
      { seed: 1, numRuns: 500 },
    );
  });

  test('is the same with its last point once or many times, and as a table', () => {
    fc.assert(
      fc.property(curves, (curve) => {
        const table = new Float32Array(256);
        sampleCurve(paddedCurve(curve), table);
        expect(paddedCurve(curve)).toHaveLength(CURVE_NUMBERS);
        for (const i of [0, 1, 77, 254, 255]) expect(table[i]).toBe(Math.fround(curveAt(curve, i / 255)));
      }),
      { seed: 1, numRuns: 200 },
    );
  });

  test('that is the diagonal changes no level of eight bits', () => {
    const table = new Float32Array(256);
    sampleCurve(DIAGONAL, table);
    expect([...table].map((height) => Math.round(height * 255))).toEqual(Array.from({ length: 256 }, (_, level) => level));
  });

  test.each<[string, unknown, string | null]>([
    ['one from corner to corner', [0, 0, 1, 1], null],
    ['eight points', Array.from({ length: 16 }, (_, i) => (i % 2 === 0 ? i / 16 : 0.5)), null],
    ['one point', [0.5, 0.5], 'a curve of 2 to 8 points, [x, y, x, y, …]'],
    ['nine points', Array.from({ length: 18 }, (_, i) => i / 18), 'a curve of 2 to 8 points, [x, y, x, y, …]'],
    ['half a point', [0, 0, 1], 'a curve of 2 to 8 points, [x, y, x, y, …]'],
    ['no number', [0, Number.NaN, 1, 1], 'a curve of 2 to 8 points, [x, y, x, y, …]'],
    ['a word', 'S', 'a curve of 2 to 8 points, [x, y, x, y, …]'],
    ['a point outside', [0, 0, 1, 1.5], 'a curve whose points lie from 0 to 1'],
    ['points out of order', [0.5, 0, 0.2, 1], 'a curve with each point further right than the one before'],
    ['two points above each other', [0.5, 0, 0.5, 1], 'a curve with each point further right than the one before'],
  ])('is told apart from %s', (_what, value, misfit) => {
    expect(curveMisfit(value)).toBe(misfit);
  });
});
