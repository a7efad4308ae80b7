import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function color(params: { hueRad?: number; saturation?: number; brightness?: number; alpha?: number }): number[] {
  const { ctx } = fakeContext(definition, { params });
  create(ctx).update({} as never);
  return [...ctx.outputs.color.value].map((x) => Math.round(x * 1000) / 1000);
}

test.each([
  [0, [1, 0, 0, 1]],
  [60, [1, 1, 0, 1]],
  [120, [0, 1, 0, 1]],
  [240, [0, 0, 1, 1]],
  [30, [1, 0.5, 0, 1]],
  [-60, [1, 0, 1, 1]],
  [480, [0, 1, 0, 1]],
])('the hue of %d° is %j', (degrees, expected) => {
  expect(color({ hueRad: (degrees / 180) * Math.PI })).toEqual(expected);
});

test('saturation 0 is a gray of that brightness, brightness 0 is black', () => {
  expect(color({ saturation: 0, brightness: 0.4, alpha: 0.5 })).toEqual([0.4, 0.4, 0.4, 0.5]);
  expect(color({ brightness: -1 })).toEqual([0, 0, 0, 1]);
  expect(color({ saturation: 9, brightness: 9 })).toEqual([1, 0, 0, 1]);
});
