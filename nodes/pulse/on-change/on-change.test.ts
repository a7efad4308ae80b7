import { describe, expect, test } from '@jest/globals';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Direction = (typeof definition.params.direction.options)[number]['value'];

function pulses(numbers: readonly number[], direction: Direction, least = 0): number[][] {
  const { ctx, set, tick } = fakeContext(definition, { params: { direction, least } });
  const node = create(ctx);
  return numbers.map((number) => {
    set('number', number);
    tick(0.1);
    node.update({} as never);
    return pulseNumbers(ctx.outputs.changed);
  });
}

describe('on change', () => {
  test.each<[Direction, number[][]]>([
    ['changes', [[], [], [1], [], [0], [2]]],
    ['rises', [[], [], [1], [], [], [2]]],
    ['falls', [[], [], [], [], [0], []]],
  ])('gives a pulse when it %s, and none for what it is at first', (direction, expected) => {
    expect(pulses([0, 0, 1, 1, 0, 2], direction)).toEqual(expected);
  });

  test('waits until it has gone far enough, in small steps too', () => {
    expect(pulses([0, 0.4, 0.8, 1.2, 0.9, 0.1], 'changes', 1)).toEqual([[], [], [], [1.2], [], [0.1]]);
    expect(pulses([0, 0.4, 0.1, 0.9, 1.2], 'rises', 1)).toEqual([[], [], [], [], [1.2]]);
  });

  test('forgets after a reset', () => {
    const { ctx, set } = fakeContext(definition);
    const node = create(ctx);
    node.update({} as never);
    set('number', 5);
    node.reset?.();
    node.update({} as never);
    expect(ctx.outputs.changed.count).toBe(0);
  });
});
