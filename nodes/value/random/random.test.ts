import { describe, expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { low?: number; high?: number; whole?: boolean; seed?: number } = {}, chance = 0.5) {
  const draw = createPulseQueue();
  const { ctx } = fakeContext(definition, { params, inputs: { draw }, services: { random: () => chance } });
  const node = create(ctx);
  node.update({} as never);
  draw.emit();
  const next = (): number => {
    node.update({} as never);
    return ctx.outputs.number.value;
  };
  return { node, draw, next, first: ctx.outputs.number.value };
}

function sequence(count: number, ...args: Parameters<typeof start>): number[] {
  const { next } = start(...args);
  return Array.from({ length: count }, next);
}

describe('random', () => {
  test('is uniformly distributed between its limits', () => {
    const numbers = sequence(4000, { low: -2, high: 6 });
    expect(Math.min(...numbers)).toBeGreaterThanOrEqual(-2);
    expect(Math.max(...numbers)).toBeLessThan(6);
    const tenths = Array.from({ length: 10 }, (_, i) => numbers.filter((x) => Math.floor(((x + 2) / 8) * 10) === i).length);
    // 400 expected in each; a fair draw strays by more than five standard deviations (19) once in a million times.
    for (const count of tenths) expect(Math.abs(count - 400)).toBeLessThan(95);
  });

  test('whole numbers are equally frequent, including the last one', () => {
    const numbers = sequence(6000, { low: 1, high: 6, whole: true });
    for (const face of [1, 2, 3, 4, 5, 6]) expect(Math.abs(numbers.filter((x) => x === face).length - 1000)).toBeLessThan(145);
  });

  test('is reproducible, and differs with another seed or node', () => {
    expect(sequence(5, { seed: 3 })).toEqual(sequence(5, { seed: 3 }));
    expect(sequence(5, { seed: 3 })).not.toEqual(sequence(5, { seed: 4 }));
    expect(sequence(5, {}, 0.25)).not.toEqual(sequence(5, {}, 0.5));
  });

  test('keeps its number between pulses, and restarts after a reset', () => {
    const { node, draw, next, first } = start();
    const second = next();
    expect(second).not.toBe(first);
    draw.clear();
    expect([next(), next()]).toEqual([second, second]);
    node.reset?.();
    expect(next()).toBe(first);
  });
});
