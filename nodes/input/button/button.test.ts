import { describe, expect, test } from '@jest/globals';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(presses = 0) {
  const fake = fakeContext(definition, { params: { presses } });
  const node = create(fake.ctx);
  return {
    node,
    press: (count: number): number[] => {
      fake.set('presses', count);
      fake.tick(1 / 60);
      node.update({} as never);
      return pulseNumbers(fake.ctx.outputs.pressed);
    },
  };
}

describe('button', () => {
  test('gives a pulse per press, none in between', () => {
    const { press } = start();
    expect([press(0), press(1), press(1), press(2)]).toEqual([[], [1], [], [2]]);
  });

  test('two presses within a frame are two pulses', () => {
    const { press } = start();
    press(0);
    expect(press(2)).toEqual([1, 2]);
  });

  test('presses from before the first frame, or before a reset, are none', () => {
    const { node, press } = start();
    expect(press(5)).toEqual([]);
    press(6);
    node.reset?.();
    expect([press(9), press(10)]).toEqual([[], [1]]);
  });

  test('a count that was taken back gives nothing, and goes on from there', () => {
    const { press } = start();
    press(4);
    expect([press(0), press(1)]).toEqual([[], [1]]);
  });
});
