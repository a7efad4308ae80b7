import { expect, test } from '@jest/globals';
import { addPointer, createPointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { claimPointer } from '../../kit/pointers.ts';
import { createGrip } from './grip.ts';
import { createSpot } from './spot.ts';

test.each([
  ['nearer', 1, false],
  ['farther', 5, true],
])('a press on a copy 2 m away, of which something %s claims the press too', (_, otherM, isHeld) => {
  const [place, other] = [{}, {}];
  const grip = createGrip(place);
  const spot = createSpot(0, () => {
    throw new Error('Nothing is anchored.');
  });
  const frame = createSessionFrame();
  frame.viewCount = 1;
  const pointer = createPointer();
  Object.assign(pointer, { id: 1, phase: 'start' });
  addPointer(frame.input, pointer);
  claimPointer(pointer, place, 2);
  grip.begin(pointer, spot);
  claimPointer(pointer, other, otherM);
  pointer.phase = 'hold';
  expect(grip.update(frame, () => null, { minScale: 1, maxScale: 1 })).toBe(null);
  expect(grip.held).toBe(isHeld ? spot : null);
});
