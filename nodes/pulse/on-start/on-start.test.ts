import { describe, expect, test } from '@jest/globals';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** The frames, from 0, in which a pulse came. */
function frames(delayS: number, count: number, deltaS: number, resetAt = -1): number[] {
  const { ctx, tick } = fakeContext(definition, { params: { delayS } });
  const node = create(ctx);
  return Array.from({ length: count }, (_, frame) => {
    if (frame > 0) tick(deltaS);
    if (frame === resetAt) node.reset?.();
    node.update({} as never);
    return pulseNumbers(ctx.outputs.pulse).map(() => frame);
  }).flat();
}

describe('on start', () => {
  test('gives one pulse, in the first frame', () => {
    expect(frames(0, 5, 0.1)).toEqual([0]);
  });

  test('or in the first frame after its time', () => {
    expect(frames(0.25, 10, 0.1)).toEqual([3]);
    expect(frames(0.25, 10, 1 / 8)).toEqual([2]);
  });

  test('and again after a reset, counted from there', () => {
    expect(frames(0, 5, 0.1, 3)).toEqual([0, 3]);
    expect(frames(0.25, 9, 0.1, 4)).toEqual([3, 7]);
  });
});
