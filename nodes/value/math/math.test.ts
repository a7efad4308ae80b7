import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Operation = (typeof definition.params.operation.options)[number]['value'];

function compute(operation: Operation, a: number, b: number): number {
  const { ctx } = fakeContext(definition, { params: { operation, a, b } });
  create(ctx).update({} as never);
  return ctx.outputs.result.value;
}

describe('value/math', () => {
  test.each([
    ['add', 2, 3, 5],
    ['subtract', 2, 3, -1],
    ['multiply', 2, 3, 6],
    ['divide', 3, 2, 1.5],
    ['divide', 3, 0, 0],
    ['remainder', -0.25, 1, 0.75],
    ['remainder', 5, 0, 0],
    ['power', 2, 10, 1024],
    ['power', -1, 0.5, 0],
    ['minimum', 2, 3, 2],
    ['maximum', 2, 3, 3],
  ] as const)('%s of %d and %d is %d', (operation, a, b, expected) => {
    expect(compute(operation, a, b)).toBeCloseTo(expected, 12);
  });

  test('sine and cosine take B as the factor, radians', () => {
    expect(compute('sine', Math.PI / 4, 2)).toBeCloseTo(1, 12);
    expect(compute('cosine', Math.PI, 1)).toBeCloseTo(-1, 12);
  });

  test('the default operation is one of the options', () => {
    const { operation } = definition.params;
    expect(operation.options.map((o) => o.value)).toContain(operation.default);
  });
});
