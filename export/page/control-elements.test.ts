import { expect, test } from '@jest/globals';
import { sliderText } from './control-elements.ts';

test.each([
  [0, 1, 0.05, 0.5, '0.50'],
  [0, 10, 1, 3, '3'],
  [0, 10, 0.25, 2.5, '2.5'],
  [0, 1, 0, 1 / 3, '0.33'],
  [0, 500, 0, 123.456, '123'],
  [2, 2, 0, 2, '2'],
])('a slider from %d to %d by %d shows %d as %s', (min, max, step, value, text) => {
  expect(sliderText({ min, max, step }, value)).toBe(text);
});
