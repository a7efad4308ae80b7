import { expect, test } from '@jest/globals';
import { standOnFloor, visibleScale } from './stand-on-floor.ts';

test('the lowest point of a model stands on the floor, and its middle over the point', () => {
  const { positionM, scale } = standOnFloor([1, -2], { min: [-0.1, -0.2, 0], max: [0.3, 0.4, 0.4] });
  expect(scale).toBe(1);
  expect(positionM).toEqual([0.9, 0.2, -2.2]);
});

test('a model of 154 m is drawn at a two-hundredth, and still stands on the floor', () => {
  const { positionM, scale } = standOnFloor([0, -1], { min: [-12, 0, -88], max: [12, 78, 66] });
  expect(scale).toBe(0.005);
  // Its middle in z is at −11 units.
  expect(positionM).toEqual([0, 0, -0.945]);
});

test.each([
  [0, 1],
  [0.1, 1],
  [1, 1],
  [1.5, 0.5],
  [8, 0.1],
  [300, 0.002],
  [0.03, 10],
  // The greatest scale of a Transform.
  [0.006, 10],
])('a model of %d m gets the round scale %d', (sizeM, scale) => {
  expect(visibleScale(sizeM)).toBe(scale);
});

test('a model of unknown size stands at the point as it is', () => {
  expect(standOnFloor([0.1234, -2.5], null)).toEqual({ positionM: [0.123, 0, -2.5], scale: 1 });
});
