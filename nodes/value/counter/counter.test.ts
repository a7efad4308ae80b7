import { describe, expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { start?: number; step?: number; cycle?: number } = {}) {
  const inputs = { up: createPulseQueue(), down: createPulseQueue(), reset: createPulseQueue() };
  const fake = fakeContext(definition, { params, inputs });
  const node = create(fake.ctx);
  /** A frame with so many pulses: the count after it, and the numbers of the pulses that led around. */
  const frame = (pulses: { up?: number[]; down?: number[]; reset?: number[] }): [number, number[]] => {
    for (const port of ['up', 'down', 'reset'] as const) {
      inputs[port].clear();
      for (const number of pulses[port] ?? []) inputs[port].emit().number = number;
    }
    fake.tick(1 / 60);
    node.update({} as never);
    return [fake.ctx.outputs.number.value, pulseNumbers(fake.ctx.outputs.around)];
  };
  return { frame, node };
}

describe('counter', () => {
  test('counts every pulse, also several in a frame, up and down', () => {
    const { frame } = start({ start: 10, step: 2 });
    expect(frame({})).toEqual([10, []]);
    expect(frame({ up: [0, 0, 0] })).toEqual([16, []]);
    expect(frame({ up: [0], down: [0, 0] })).toEqual([14, []]);
    expect(frame({ down: [0, 0, 0, 0] })).toEqual([6, []]);
  });

  test('wraps, and outputs the pulse that made it wrap', () => {
    const { frame } = start({ cycle: 3, step: 0.5 });
    expect(frame({ up: [1, 2] })).toEqual([1, []]);
    expect(frame({ up: [3, 4] })).toEqual([0.5, [3]]);
    expect(frame({ down: [7, 8] })).toEqual([1, [8]]);
  });

  test('a reset applies before other pulses of the frame', () => {
    const { frame, node } = start();
    frame({ up: [0, 0] });
    expect(frame({ up: [0], reset: [0] })).toEqual([1, []]);
    node.reset?.();
    expect(frame({})).toEqual([0, []]);
  });
});
