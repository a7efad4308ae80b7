import { describe, expect, test } from '@jest/globals';
import { BLACK_TO_WHITE, type Gradient, gradientMisfit, MAX_STOPS } from '../../nodes/kit/gradient.ts';
import { flipped, gradientCss, stopsOf, withoutStop, withStop, withStopAt, withStopInGap } from './gradient-stops.ts';

const positions = (gradient: Gradient) => stopsOf(gradient).map(({ position }) => position);

const THREE: Gradient = [0, 1, 0, 0, 1, 2, 0.5, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0];

describe('a new stop', () => {
  test('has the color that is there, so nothing changes', () => {
    expect(withStop(BLACK_TO_WHITE, 0.25)).toEqual({
      gradient: [0, 0, 0, 0, 1, 0, 0.25, 0.25, 0.25, 0.25, 1, 0, 1, 1, 1, 1, 1, 0],
      index: 1,
    });
  });

  test('is not where one is, nor in a full gradient', () => {
    expect(withStop(BLACK_TO_WHITE, 1)).toBeNull();
    let full = BLACK_TO_WHITE;
    for (let added = withStopInGap(full); added; added = withStopInGap(full)) full = added.gradient;
    expect(positions(full)).toHaveLength(MAX_STOPS);
    expect(gradientMisfit(full)).toBeNull();
  });
});

test('a moved stop passes others, and shares the position of none', () => {
  expect(withStopAt(THREE, 0, 0.7)).toMatchObject({ index: 1 });
  expect(positions(withStopAt(THREE, 0, 0.7).gradient)).toEqual([0.5, 0.7, 1]);
  expect(positions(withStopAt(THREE, 0, 1).gradient)).toEqual([0.5, 0.999, 1]);
  expect(positions(withStopAt(THREE, 1, -3).gradient)).toEqual([0, 0.001, 1]);
});

test('two stops remain', () => {
  expect(positions(withoutStop(THREE, 1))).toEqual([0, 1]);
  expect(withoutStop(BLACK_TO_WHITE, 0)).toBe(BLACK_TO_WHITE);
});

test('a flipped gradient has its interpolations between the same colors', () => {
  const both = flipped(THREE);
  expect(stopsOf(both).map(({ interpolation }) => interpolation)).toEqual([1, 2, 0]);
  expect(flipped(both)).toEqual(THREE);
});

test('the drawing has hard edges where a color is held, and more stops where it eases', () => {
  const css = gradientCss(THREE);
  expect(css).toContain('rgb(255 0 0 / 1) 0%, rgb(255 0 0 / 1) 50%, rgb(0 255 0 / 1) 50%');
  expect(css.split('rgb(').length).toBeGreaterThan(12);
});
