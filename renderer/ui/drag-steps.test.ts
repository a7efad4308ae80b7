import { expect, test } from '@jest/globals';
import { NO_DRAG_KEYS } from '../drag-keys.ts';
import { createSliderDrag, keyedValue, scrubbedValue } from './drag-steps.ts';

const FINE = { fine: true, snap: false };
const SNAP = { fine: false, snap: true };

test('a slider follows the pointer; with Shift by a tenth from where Shift was pressed, and to the pointer again after it', () => {
  const drag = createSliderDrag(0.01);
  let value = drag.move(0.4, 0.2, NO_DRAG_KEYS);
  expect(value).toBe(0.4);
  value = drag.move(0.5, value, FINE);
  expect(value).toBe(0.41);
  value = drag.move(0.7, value, FINE);
  expect(value).toBe(0.43);
  value = drag.move(0.3, value, FINE);
  expect(value).toBe(0.39);
  expect(drag.move(0.31, value, NO_DRAG_KEYS)).toBe(0.31);
});

test('with Ctrl a slider and a number field stop at tens of steps', () => {
  const drag = createSliderDrag(0.01);
  expect(drag.move(0.34, 0, SNAP)).toBe(0.3);
  expect(drag.move(0.36, 0, SNAP)).toBe(0.4);
  expect(scrubbedValue(0.33, 4, 0.01, SNAP)).toBe(0.4);
  expect(scrubbedValue(-7, 1, 1, SNAP)).toBe(-10);
});

test('a number field moves by steps, and by tenths of them with Shift', () => {
  expect(scrubbedValue(0.1, 2, 0.1, NO_DRAG_KEYS)).toBe(0.3);
  expect(scrubbedValue(5, -3, 1, FINE)).toBe(4.7);
});

test('an arrow key moves by a step, by a tenth of it with Shift, and to the next whole ten of steps with Ctrl', () => {
  expect(keyedValue(5400, 1, 50, NO_DRAG_KEYS)).toBe(5450);
  expect(keyedValue(5400, -1, 50, FINE)).toBe(5395);
  expect(keyedValue(5395, 1, 50, SNAP)).toBe(5500);
  expect(keyedValue(5395, -1, 50, SNAP)).toBe(5000);
  // From a whole ten to the next one, in spite of binary fractions.
  expect(keyedValue(0.3, 1, 0.01, SNAP)).toBe(0.4);
  expect(keyedValue(0.3, -1, 0.01, SNAP)).toBe(0.2);
  expect(keyedValue(-0.3, -1, 0.01, SNAP)).toBe(-0.4);
});
