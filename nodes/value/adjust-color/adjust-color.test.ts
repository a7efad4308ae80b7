import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function adjust(base: readonly number[], params: { hueRad?: number; saturation?: number; lightness?: number }): number[] {
  const { ctx } = fakeContext(definition, { params: { base, ...params } });
  create(ctx).update({} as never);
  return [...ctx.outputs.color.value].map((x) => Math.round(x * 1000) / 1000);
}

const RED = [1, 0, 0, 0.5];

describe('adjust color', () => {
  test('changes nothing by itself', () => {
    expect(adjust([0.2, 0.4, 0.6, 0.8], {})).toEqual([0.2, 0.4, 0.6, 0.8]);
  });

  test('turns red to green in a third of a turn, to magenta a sixth back, and to itself in a whole one', () => {
    expect(adjust(RED, { hueRad: (2 * Math.PI) / 3 })).toEqual([0, 1, 0, 0.5]);
    expect(adjust(RED, { hueRad: -Math.PI / 3 })).toEqual([1, 0, 1, 0.5]);
    expect(adjust(RED, { hueRad: 2 * Math.PI })).toEqual(RED);
  });

  test('becomes a gray of the same lightness, and is limited to full saturation', () => {
    expect(adjust(RED, { saturation: 0 })).toEqual([0.5, 0.5, 0.5, 0.5]);
    expect(adjust([0.75, 0.25, 0.25, 1], { saturation: 4 })).toEqual([1, 0, 0, 1]);
  });

  test('lightens to white and darkens to black', () => {
    expect(adjust(RED, { lightness: 0.25 })).toEqual([1, 0.5, 0.5, 0.5]);
    expect(adjust(RED, { lightness: 1 })).toEqual([1, 1, 1, 0.5]);
    expect(adjust(RED, { lightness: -1 })).toEqual([0, 0, 0, 0.5]);
  });
});
