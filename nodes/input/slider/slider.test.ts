import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test.each([
  [-2, 2],
  [2, -2],
])('gives what it is set to, within its ends %d and %d', (min, max) => {
  const { ctx, set } = fakeContext(definition, { params: { min, max, value: 1.5 } });
  const node = create(ctx);
  const given = [1.5, 7, -7].map((value) => {
    set('value', value);
    node.update({} as never);
    return ctx.outputs.number.value;
  });
  expect(given).toEqual([1.5, 2, -2]);
});
