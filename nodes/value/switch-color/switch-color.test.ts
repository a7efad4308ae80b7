import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test.each([
  [0, [0.1, 0.2, 0.3, 1]],
  [1, [0.4, 0.5, 0.6, 1]],
  [1.6, [0.7, 0.8, 0.9, 1]],
  [3, [1, 0, 1, 0.5]],
  [9, [1, 0, 1, 0.5]],
  [-1, [0.1, 0.2, 0.3, 1]],
])('index %d chooses %j', (index, expected) => {
  const { ctx } = fakeContext(definition, {
    params: { index, first: [0.1, 0.2, 0.3, 1], second: [0.4, 0.5, 0.6, 1], third: [0.7, 0.8, 0.9, 1], fourth: [1, 0, 1, 0.5] },
  });
  create(ctx).update({} as never);
  expect([...ctx.outputs.chosen.value]).toEqual(expected);
});
