import { expect, test } from '@jest/globals';
import { addPointer, createPointer, createSessionInput } from '../../export/runtime/sessions/input/session-input.ts';
import { claimPointer, pointerById } from './pointers.ts';

test('the first who asks at the start of a press gets it, and keeps it', () => {
  const pointer = createPointer();
  const [first, second] = [{}, {}];
  expect(claimPointer(pointer, first)).toBe(false);
  pointer.phase = 'start';
  expect([claimPointer(pointer, first), claimPointer(pointer, second)]).toEqual([true, false]);
  pointer.phase = 'hold';
  expect([claimPointer(pointer, first), claimPointer(pointer, second)]).toEqual([true, false]);
});

test('a pointer is found by its id while it is listed', () => {
  const input = createSessionInput();
  const pointer = Object.assign(createPointer(), { id: 7 });
  addPointer(input, pointer);
  expect([pointerById(input, 7), pointerById(input, 8)]).toEqual([pointer, null]);
  input.pointerCount = 0;
  expect(pointerById(input, 7)).toBe(null);
});
