import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('combines its channels, clamped to 0 to 1', () => {
  const { ctx, set } = fakeContext(definition, { params: { red: 0.25, green: 0.5, blue: 0.75, alpha: 0.1 } });
  const node = create(ctx);
  node.update({} as never);
  expect([...ctx.outputs.color.value]).toEqual([0.25, 0.5, 0.75, 0.1]);
  set('red', 7);
  set('alpha', -1);
  node.update({} as never);
  expect([...ctx.outputs.color.value]).toEqual([1, 0.5, 0.75, 0]);
});
