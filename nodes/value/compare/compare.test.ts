import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Operation = (typeof definition.params.operation.options)[number]['value'];

function compare(operation: Operation, a: number, b: number, tolerance: number): boolean {
  const { ctx } = fakeContext(definition, { params: { operation, a, b, tolerance } });
  create(ctx).update({} as never);
  return ctx.outputs.result.value;
}

/** For A one less than B, equal, and one more. */
test.each<[Operation, boolean[]]>([
  ['greater', [false, false, true]],
  ['greater-equal', [false, true, true]],
  ['less', [true, false, false]],
  ['less-equal', [true, true, false]],
  ['equal', [false, true, false]],
  ['not-equal', [true, false, true]],
])('%s', (operation, expected) => {
  expect([1, 2, 3].map((a) => compare(operation, a, 2, 0))).toEqual(expected);
  // Within the tolerance all are equal.
  expect([1, 2, 3].map((a) => compare(operation, a, 2, 1))).toEqual(Array(3).fill(expected[1]));
});
