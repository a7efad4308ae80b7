import { describe, expect, test } from '@jest/globals';
import { create } from './runtime.ts';

function bound(value: number | boolean | Float64Array, postfix: string, otherwise: readonly number[], timeS = 0): unknown {
  const output = { value };
  create({ outputs: { value: output }, config: { postfix, otherwise }, clock: { timeS, frame: 4 } }).update({} as never);
  return output.value;
}

describe('a param bound to an expression', () => {
  test('has the result of the expression at the time and frame', () => {
    expect(bound(0, 'time 2 * frame +', [0], 1.5)).toBe(7);
    expect([...(bound(new Float64Array(3), 'time 0 1', [9, 9, 9], 2) as Float64Array)]).toEqual([2, 0, 1]);
  });

  test('is on or off where it is a toggle', () => {
    expect(bound(false, 'time 1 > 0 !=', [0], 2)).toBe(true);
    expect(bound(true, 'time 1 > 0 !=', [1], 0)).toBe(false);
  });

  test('replaces each result that is not finite with its own value', () => {
    expect(bound(0, '1 0 /', [0.5])).toBe(0.5);
    expect(bound(0, '0 0 /', [0.25])).toBe(0.25);
    expect([...(bound(new Float64Array(2), '1 negate sqrt 3', [7, 8]) as Float64Array)]).toEqual([7, 3]);
  });
});
