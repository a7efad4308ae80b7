import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function chosen(options: string, value: number): [number, string] {
  const { ctx } = fakeContext(definition, { params: { options, value } });
  create(ctx).update({} as never);
  return [ctx.outputs.index.value, ctx.outputs.word.value];
}

test.each([
  [0, [0, 'Day']],
  [2, [2, 'Night']],
  [9, [2, 'Night']],
  [-1, [0, 'Day']],
])('number %d of three is %j', (value, expected) => {
  expect(chosen('Day, Dusk,  Night ,', value)).toEqual(expected);
});

test('there may be nothing to choose from', () => {
  expect(chosen(' , ', 3)).toEqual([0, '']);
});
