import { describe, expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(halfLifeS: number) {
  const jump = createPulseQueue();
  const fake = fakeContext(definition, { params: { vector: [1, 2, 3], halfLifeS }, inputs: { jump } });
  const node = create(fake.ctx);
  const step = (deltaS: number): number[] => {
    fake.tick(deltaS);
    node.update({} as never);
    jump.clear();
    return [...fake.ctx.outputs.result.value];
  };
  return { ...fake, node, jump, step };
}

describe('smooth vector', () => {
  test('begins where its vector is, and goes half of the way in each half-life', () => {
    const { set, step } = start(0.5);
    expect(step(0.1)).toEqual([1, 2, 3]);
    set('vector', [9, 2, -5]);
    expect([step(0.5), step(0.5)]).toEqual([
      [5, 2, -1],
      [7, 2, -3],
    ]);
  });

  test.each([24, 60, 144])('is where it is after a second, at %d frames per second', (rate) => {
    const { set, step } = start(0.3);
    step(0);
    set('vector', [0, 2, 4]);
    for (let i = 0; i < rate - 1; i++) step(1 / rate);
    const left = 2 ** (-1 / 0.3);
    expect(step(1 / rate)).toEqual([expect.closeTo(left, 12), 2, expect.closeTo(4 - left, 12)]);
  });

  test('follows at once on a jump, without a half-life, and after a reset', () => {
    const { set, node, jump, step } = start(0.5);
    step(0);
    set('vector', [0, 0, 0]);
    jump.emit();
    expect(step(0.01)).toEqual([0, 0, 0]);
    set('vector', [4, 4, 4]);
    node.reset?.();
    expect(step(0.01)).toEqual([4, 4, 4]);
    set('halfLifeS', 0);
    set('vector', [1, 1, 1]);
    expect(step(0.01)).toEqual([1, 1, 1]);
  });
});
