import { describe, expect, test } from '@jest/globals';
import { clampTo, formatNumber, parseNumber, rangeOf } from './units.ts';

describe('numbers as they are shown', () => {
  test.each([
    [0, '0'],
    [-0, '0'],
    [1, '1'],
    [0.5, '0.5'],
    [1 / 3, '0.3333'],
    [-12.34567, '-12.3457'],
    [100, '100'],
    [0.00001, '1.000e-5'],
    [12_345_678, '1.235e+7'],
  ])('%d is %s', (value, text) => {
    expect(formatNumber(value)).toBe(text);
  });

  test.each([
    ['12', 'px', 12],
    ['12 px', 'px', 12],
    ['12px', 'px', 12],
    ['0,5', 'none', 0.5],
    ['.5', 'none', 0.5],
    ['-1e2', 'm', -100],
    ['180°', 'rad', Math.PI],
    ['90', 'rad', Math.PI / 2],
  ] as const)('“%s” in %s is %d', (text, unit, value) => {
    expect(parseNumber(text, unit)).toBeCloseTo(value, 12);
  });

  test.each(['', 'abc', '1 2', '12 kg', '1..2', 'NaN', 'Infinity', '1e999', '--1'])('“%s” is none', (text) => {
    expect(parseNumber(text, 'm')).toBeNull();
  });

  test('what is shown in degrees and typed again is the same angle', () => {
    for (const rad of [0, 0.1, -2, Math.PI]) {
      const shown = formatNumber((rad * 180) / Math.PI);
      expect(parseNumber(shown, 'rad')).toBeCloseTo(rad, 5);
    }
  });
});

describe('ranges', () => {
  test('a step is found where none is named: 100 to 1,000 of them over the range', () => {
    for (const [min, max] of [
      [0, 1],
      [0, 60],
      [-1000, 1000],
      [2000, 12_000],
    ] as const) {
      const { step } = rangeOf({ min, max });
      expect((max - min) / step).toBeGreaterThanOrEqual(100);
      expect((max - min) / step).toBeLessThanOrEqual(1000);
    }
    expect(rangeOf({}).step).toBe(0.01);
    expect(rangeOf({ min: 0, max: 1, step: 0.25 }).step).toBe(0.25);
  });

  test('clamping leaves open ends open', () => {
    expect(clampTo(5, { min: 0, max: 1 })).toBe(1);
    expect(clampTo(-5, { min: undefined, max: 1 })).toBe(-5);
    expect(clampTo(5, { min: 0, max: undefined })).toBe(5);
  });
});
