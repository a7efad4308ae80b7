import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Space = (typeof definition.params.space.options)[number]['value'];

const RED = [1, 0, 0, 1];
const BLUE = [0, 0, 1, 1];

/** In bytes. */
function mix(a: readonly number[], b: readonly number[], amount: number, space: Space): number[] {
  const { ctx } = fakeContext(definition, { params: { a, b, amount, space } });
  create(ctx).update({} as never);
  return [...ctx.outputs.color.value].map((x) => Math.round(x * 255));
}

describe('mix colors', () => {
  // What browsers make of `color-mix(in oklab, red, blue)`, `… in srgb-linear` and `… in srgb`.
  test.each<[Space, number[]]>([
    ['perceived', [140, 83, 162, 255]],
    ['light', [188, 0, 188, 255]],
    ['screen', [128, 0, 128, 255]],
  ])('half of red and blue, %s, is what CSS has', (space, expected) => {
    expect(mix(RED, BLUE, 0.5, space)).toEqual(expected);
  });

  test.each<Space>(['perceived', 'light', 'screen'])('is one and the other at its ends, and beyond, %s', (space) => {
    expect([mix(RED, BLUE, 0, space), mix(RED, BLUE, -3, space)]).toEqual([
      [255, 0, 0, 255],
      [255, 0, 0, 255],
    ]);
    expect([mix(RED, BLUE, 1, space), mix(RED, BLUE, 9, space)]).toEqual([
      [0, 0, 255, 255],
      [0, 0, 255, 255],
    ]);
  });

  test('a transparent color does not contribute', () => {
    expect(mix(RED, [0, 0, 1, 0], 0.5, 'screen')).toEqual([255, 0, 0, 128]);
    expect(mix([1, 0, 0, 0], [0, 0, 1, 0], 0.5, 'screen')).toEqual([128, 0, 128, 0]);
  });
});
