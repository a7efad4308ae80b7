import { expect, test } from '@jest/globals';
import { createFrameTime } from './frame-time.ts';
import { createSessionFrame } from './session-frame.ts';

test('begins at 0 wherever the clock stands, goes on with it, and leaps over nothing', () => {
  const frame = createSessionFrame();
  const time = createFrameTime();
  const steps = [1000, 1000.25, 1000.5, 1060.5, 1060.75].map((nowS) => {
    time.write(frame, nowS);
    return [frame.timeS, frame.deltaS];
  });
  // A minute away counts as half a second.
  expect(steps).toEqual([
    [0, 0],
    [0.25, 0.25],
    [0.5, 0.25],
    [1, 0.5],
    [1.25, 0.25],
  ]);
});

test('counts frames, and none of those that are drawn again while time stands', () => {
  const frame = createSessionFrame();
  const time = createFrameTime();
  const numbers = [10, 10, 10.1, 10.1, 10.1, 10.2].map((nowS) => {
    time.write(frame, nowS);
    return frame.index;
  });
  expect(numbers).toEqual([0, 0, 1, 1, 1, 2]);
});
