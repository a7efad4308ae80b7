import { expect, test } from '@jest/globals';
import { createWheelDevice, type WheelStep, zoomFactor } from './wheel-device.ts';

const step = (part: Partial<WheelStep>): WheelStep => ({ deltaX: 0, deltaY: 0, deltaMode: 0, ctrlKey: false, timeStamp: 0, ...part });

/** Whether each step of a sequence, `gapMs` apart, is taken for a trackpad’s. */
function devices(gapMs: number, parts: readonly Partial<WheelStep>[]): readonly boolean[] {
  const device = createWheelDevice();
  return parts.map((part, i) => device.isTrackpad(step({ ...part, timeStamp: i * gapMs })));
}

test('notches of a wheel, by pixels, by lines, and as fractions in a zoomed page', () => {
  expect(devices(30, [{ deltaY: 100 }, { deltaY: -100 }, { deltaY: 53 }])).toEqual([false, false, false]);
  expect(devices(30, [{ deltaY: 3, deltaMode: 1 }])).toEqual([false]);
  expect(devices(30, [{ deltaY: 90.909, wheelDeltaY: -120 }])).toEqual([false]);
});

test('two fingers on a trackpad, from the first pixels through a fast swipe', () => {
  const swipe = [1, 4, 18, 64, 120, 90, 41, 12, 2].map((deltaY) => ({ deltaY, wheelDeltaY: -3 * deltaY }));
  expect(devices(16, swipe)).toEqual(swipe.map(() => true));
  expect(devices(16, [{ deltaX: 12, deltaY: 60 }])).toEqual([true]);
});

test('a swipe that begins at full speed is corrected by its first small step', () => {
  expect(devices(16, [{ deltaY: 80 }, { deltaY: 30 }, { deltaY: 90 }])).toEqual([false, true, true]);
});

test('the device changes with the next gesture', () => {
  expect(devices(200, [{ deltaY: 2 }, { deltaY: 100 }, { deltaY: 3 }])).toEqual([true, false, true]);
});

test('a pinch zooms by as much as the fingers, a notch with Ctrl by a seventh, up to a factor of 2', () => {
  expect(zoomFactor(step({ deltaY: -5, ctrlKey: true }))).toBeCloseTo(2 ** 0.1, 10);
  expect(zoomFactor(step({ deltaY: 100, ctrlKey: true }))).toBeCloseTo(2 ** -0.2, 10);
  expect(zoomFactor(step({ deltaY: -3, deltaMode: 1, ctrlKey: true }))).toBeCloseTo(2 ** 0.15, 10);
  expect(zoomFactor(step({ deltaY: -5000, ctrlKey: true }))).toBe(2);
});
