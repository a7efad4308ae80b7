import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('puts its numbers into their places, also when they change', () => {
  const { ctx, set } = fakeContext(definition, { params: { x: 1.5, y: -2, z: 0.25 } });
  const node = create(ctx);
  node.update({} as never);
  expect([...ctx.outputs.vector.value]).toEqual([1.5, -2, 0.25]);
  set('y', 7);
  node.update({} as never);
  expect([...ctx.outputs.vector.value]).toEqual([1.5, 7, 0.25]);
});
