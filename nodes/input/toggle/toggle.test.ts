import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('gives whether it is on, also when that changes', () => {
  const { ctx, set } = fakeContext(definition, { params: { value: true } });
  const node = create(ctx);
  node.update({} as never);
  expect(ctx.outputs.on.value).toBe(true);
  set('value', false);
  node.update({} as never);
  expect(ctx.outputs.on.value).toBe(false);
});
