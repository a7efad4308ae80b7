import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('gives the channels, and the hue in radians', () => {
  const { ctx } = fakeContext(definition, { params: { color: [0.2, 0.8, 0.2, 0.5] } });
  create(ctx).update({} as never);
  const { red, green, blue, alpha, hueRad, saturation, brightness } = ctx.outputs;
  expect([red.value, green.value, blue.value, alpha.value]).toEqual([0.2, 0.8, 0.2, 0.5]);
  expect(hueRad.value).toBeCloseTo((2 * Math.PI) / 3, 12);
  expect([saturation.value, brightness.value]).toEqual([expect.closeTo(0.75, 12), 0.8]);
});
