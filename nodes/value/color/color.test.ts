import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('gives its color, also when that changes', () => {
  const { ctx, set } = fakeContext(definition, { params: { value: [0.1, 0.2, 0.3, 0.4] } });
  const node = create(ctx);
  node.update({} as never);
  expect([...ctx.outputs.color.value]).toEqual([0.1, 0.2, 0.3, 0.4]);
  set('value', [1, 1, 0, 1]);
  node.update({} as never);
  expect([...ctx.outputs.color.value]).toEqual([1, 1, 0, 1]);
});
