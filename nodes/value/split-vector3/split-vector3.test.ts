import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('gives the numbers in their order', () => {
  const { ctx } = fakeContext(definition, { params: { vector: [1.5, -2, 0.25] } });
  create(ctx).update({} as never);
  const { x, y, z } = ctx.outputs;
  expect([x.value, y.value, z.value]).toEqual([1.5, -2, 0.25]);
});
