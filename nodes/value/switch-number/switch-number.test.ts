import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test.each([
  [0, 10],
  [1, 20],
  [1.6, 30],
  [3, 40],
  [9, 40],
  [-1, 10],
])('index %d chooses %j', (index, expected) => {
  const { ctx } = fakeContext(definition, {
    params: { index, first: 10, second: 20, third: 30, fourth: 40 },
  });
  create(ctx).update({} as never);
  expect(ctx.outputs.chosen.value).toEqual(expected);
});
