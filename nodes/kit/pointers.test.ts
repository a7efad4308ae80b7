import { expect, test } from '@jest/globals';
import { addPointer, createPointer, createSessionInput } from '../../export/runtime/sessions/input/session-input.ts';
import { claimPointer, pointerById, rayTurnRad } from './pointers.ts';

test('the first who asks at the start of a press gets it, and keeps it', () => {
  const pointer = createPointer();
  const [first, second] = [{}, {}];
  expect(claimPointer(pointer, first)).toBe(false);
  pointer.phase = 'start';
  expect([claimPointer(pointer, first), claimPointer(pointer, second)]).toEqual([true, false]);
  pointer.phase = 'hold';
  expect([claimPointer(pointer, first), claimPointer(pointer, second)]).toEqual([true, false]);
});

test('of several, the nearest gets it in any order, and nobody later', () => {
  const pointer = createPointer();
  pointer.phase = 'start';
  const [far, near] = [{}, {}];
  expect([claimPointer(pointer, far, 2), claimPointer(pointer, near, 1), claimPointer(pointer, far, 2)]).toEqual([true, true, false]);
  pointer.phase = 'hold';
  expect([claimPointer(pointer, far, 0.5), pointer.owner === near]).toEqual([false, true]);
});

test('a pointer is found by its id while it is listed', () => {
  const input = createSessionInput();
  const pointer = Object.assign(createPointer(), { id: 7 });
  addPointer(input, pointer);
  expect([pointerById(input, 7), pointerById(input, 8)]).toEqual([pointer, null]);
  input.pointerCount = 0;
  expect(pointerById(input, 7)).toBe(null);
});

test('the angle between two rays is that of their directions, wherever they start', () => {
  const [a, b] = [createPointer(), createPointer()];
  const rad = 1e-4;
  b.worldFromRay.set([Math.cos(rad), 0, -Math.sin(rad), 0, 0, 1, 0, 0, Math.sin(rad), 0, Math.cos(rad), 0, 5, 6, 7, 1]);
  expect([rayTurnRad(a.worldFromRay, a.worldFromRay), rayTurnRad(a.worldFromRay, b.worldFromRay)]).toEqual([0, expect.closeTo(rad, 9)]);
  b.worldFromRay[8] = 0;
  b.worldFromRay[10] = -1;
  expect(rayTurnRad(a.worldFromRay, b.worldFromRay)).toBeCloseTo(Math.PI, 9);
});
