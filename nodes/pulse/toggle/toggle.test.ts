import { describe, expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { start?: boolean } = {}) {
  const inputs = { flip: createPulseQueue(), turnOn: createPulseQueue(), turnOff: createPulseQueue() };
  const { ctx } = fakeContext(definition, { params, inputs });
  const node = create(ctx);
  const frame = (flips: number, ons = 0, offs = 0): boolean => {
    const counts = { flip: flips, turnOn: ons, turnOff: offs };
    for (const port of ['flip', 'turnOn', 'turnOff'] as const) {
      inputs[port].clear();
      for (let i = 0; i < counts[port]; i++) inputs[port].emit();
    }
    node.update({} as never);
    return ctx.outputs.on.value;
  };
  return { node, frame };
}

describe('flip-flop', () => {
  test('flips with every pulse, also with several in a frame', () => {
    const { frame } = start();
    expect([frame(0), frame(1), frame(0), frame(2), frame(3)]).toEqual([false, true, true, true, false]);
  });

  test('is turned on and off whatever it was; off is last', () => {
    const { frame } = start();
    expect([frame(0, 1), frame(0, 2), frame(0, 0, 1), frame(1, 1, 1)]).toEqual([true, true, false, false]);
  });

  test('begins as it should, also after a reset', () => {
    const { node, frame } = start({ start: true });
    expect([frame(0), frame(1)]).toEqual([true, false]);
    node.reset?.();
    expect(frame(0)).toBe(true);
  });
});
