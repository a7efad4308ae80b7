import { describe, expect, test } from '@jest/globals';
import type { PulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(halfLifeS: number) {
  const fake = fakeContext(definition, { params: { number: 0, halfLifeS } });
  const node = create(fake.ctx);
  const step = (deltaS: number): number => {
    fake.tick(deltaS);
    node.update({} as never);
    return fake.ctx.outputs.result.value;
  };
  step(0);
  return { fake, node, step };
}

describe('smooth', () => {
  test('begins where its number is', () => {
    const { ctx, tick } = fakeContext(definition, { params: { number: 7 } });
    tick(1);
    create(ctx).update({} as never);
    expect(ctx.outputs.result.value).toBe(7);
  });

  test('halves the difference in each half-life', () => {
    const { fake, step } = start(0.5);
    fake.set('number', 8);
    expect([step(0.5), step(0.5), step(0.5)].map((x) => Math.round(x * 1e9) / 1e9)).toEqual([4, 6, 7]);
  });

  test.each([24, 60, 144])('is where it is after a second, at %d frames per second', (rate) => {
    const { fake, step } = start(0.3);
    fake.set('number', 1);
    for (let i = 0; i < rate - 1; i++) step(1 / rate);
    expect(step(1 / rate)).toBeCloseTo(1 - 2 ** (-1 / 0.3), 12);
  });

  test('follows at once without a half-life, after a long frame, on a jump and after a reset', () => {
    const { fake, node, step } = start(0.5);
    fake.set('number', 3);
    expect(step(1e6)).toBe(3);
    fake.set('number', 5);
    (fake.ctx.inputs.jump as PulseQueue).emit();
    expect(step(0.01)).toBe(5);
    (fake.ctx.inputs.jump as PulseQueue).clear();
    fake.set('number', 9);
    node.reset?.();
    expect(step(0.01)).toBe(9);
    fake.set('halfLifeS', 0);
    fake.set('number', 1);
    expect(step(0.01)).toBe(1);
  });
});
