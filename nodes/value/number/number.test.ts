import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('gives its number, also when that changes', () => {
  const { ctx, set } = fakeContext(definition, { params: { value: 2.5 } });
  const node = create(ctx);
  node.update({} as never);
  expect(ctx.outputs.number.value).toBe(2.5);
  set('value', -7);
  node.update({} as never);
  expect(ctx.outputs.number.value).toBe(-7);
});
