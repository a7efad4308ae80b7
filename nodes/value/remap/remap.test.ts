import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = Parameters<typeof fakeContext<typeof definition>>[1];

function remap(params: NonNullable<Params>['params']): number {
  const { ctx } = fakeContext(definition, { params: params ?? {} });
  create(ctx).update({} as never);
  return ctx.outputs.result.value;
}

const RANGE = { fromLow: 10, fromHigh: 20, toLow: -1, toHigh: 1 };

describe('remap', () => {
  test.each([
    [10, -1],
    [15, 0],
    [17.5, 0.5],
    [20, 1],
    [25, 1],
    [-100, -1],
  ])('%d of 10 to 20 is %d of -1 to 1', (number, expected) => {
    expect(remap({ ...RANGE, number })).toBeCloseTo(expected, 12);
  });

  test('extrapolates without clamping', () => {
    expect(remap({ ...RANGE, number: 25, clamp: false })).toBeCloseTo(2, 12);
    expect(remap({ ...RANGE, number: 5, clamp: false })).toBeCloseTo(-2, 12);
  });

  test('inverts if the end of a range is below its start', () => {
    expect(remap({ fromLow: 1, fromHigh: 0, number: 0.25 })).toBeCloseTo(0.75, 12);
  });

  test('a range without length is a step', () => {
    expect([1.9, 2, 2.1].map((number) => remap({ fromLow: 2, fromHigh: 2, number }))).toEqual([0, 1, 1]);
  });

  test('the smooth curve is 3t² − 2t³, and stays within its ends', () => {
    expect([0, 0.25, 0.5, 0.75, 1, 2].map((number) => remap({ number, curve: 'smooth', clamp: false }))).toEqual([
      0, 0.15625, 0.5, 0.84375, 1, 1,
    ]);
  });
});
