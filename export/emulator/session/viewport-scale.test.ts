import { expect, test } from '@jest/globals';
import { createViewportScale, requestScale, scaledViewport, stretchViewport } from './viewport-scale.ts';

const FULL = { x: 2, y: 0, widthPx: 4, heightPx: 2 };

test('a wish holds from the first question of a frame to its end', () => {
  const scale = createViewportScale();
  const [first, second] = [{}, {}];
  requestScale(scale, 0.5);
  expect(scaledViewport(scale, FULL, first)).toEqual({ x: 2, y: 0, widthPx: 2, heightPx: 1 });
  requestScale(scale, 1);
  expect(scaledViewport(scale, FULL, first).widthPx).toBe(2);
  expect(scaledViewport(scale, FULL, second)).toEqual(FULL);
});

test.each([
  [null, 4],
  [undefined, 4],
  [0, 4],
  [-1, 4],
  [Number.NaN, 4],
  [7, 4],
  [0.01, 1],
])('a wish of %s gives %s pixels of 4', (wish, widthPx) => {
  const scale = createViewportScale();
  requestScale(scale, wish);
  expect(scaledViewport(scale, FULL, {}).widthPx).toBe(widthPx);
});

test('the part that was drawn fills all of its own viewport, and no other', () => {
  const scale = createViewportScale();
  requestScale(scale, 0.5);
  scaledViewport(scale, FULL, {});
  const red = (values: readonly number[]) => Uint8Array.from(values.flatMap((value) => [value, 0, 0, 255]));
  const pixels = red([1, 2, 30, 40, 0, 0, 3, 4, 0, 0, 0, 0]);
  stretchViewport(pixels, 6, FULL, scale);
  expect(pixels).toEqual(red([1, 2, 30, 30, 40, 40, 3, 4, 30, 30, 40, 40]));
});
