import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test.each([
  [0, [1, 2, 3]],
  [1, [4, 5, 6]],
  [1.6, [7, 8, 9]],
  [3, [10, 11, 12]],
  [9, [10, 11, 12]],
  [-1, [1, 2, 3]],
])('index %d chooses %j', (index, expected) => {
  const { ctx } = fakeContext(definition, {
    params: { index, first: [1, 2, 3], second: [4, 5, 6], third: [7, 8, 9], fourth: [10, 11, 12] },
  });
  create(ctx).update({} as never);
  expect([...ctx.outputs.chosen.value]).toEqual(expected);
});
