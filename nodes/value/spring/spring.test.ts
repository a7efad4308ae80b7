import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { frequencyHz: number; damping: number }) {
  const fake = fakeContext(definition, { params: { number: 1, ...params } });
  const node = create(fake.ctx);
  node.update({} as never);
  fake.set('number', 0);
  const run = (seconds: number, frames: number): number => {
    for (let i = 0; i < frames; i++) {
      fake.tick(seconds / frames);
      node.update({} as never);
    }
    return fake.ctx.outputs.result.value;
  };
  return { fake, node, run };
}

describe('spring', () => {
  test('without damping is a cosine of its frequency', () => {
    const { fake, run } = start({ frequencyHz: 0.5, damping: 0 });
    expect(run(0.5, 13)).toBeCloseTo(0, 9);
    expect(fake.ctx.outputs.speed.value).toBeCloseTo(-Math.PI, 9);
    expect(run(0.5, 7)).toBeCloseTo(-1, 9);
    expect(run(1, 1)).toBeCloseTo(1, 9);
  });

  test('at damping 1 is (1 + ωt) e^(−ωt), and never goes beyond', () => {
    const { run } = start({ frequencyHz: 1, damping: 1 });
    const omega = 2 * Math.PI;
    expect(run(0.25, 9)).toBeCloseTo((1 + omega * 0.25) * Math.exp(-omega * 0.25), 9);
    expect(run(5, 100)).toBeGreaterThan(0);
  });

  test('at damping 0.5 goes beyond by e^(−πζ/√(1−ζ²)), half a damped turn later', () => {
    const { run } = start({ frequencyHz: 1, damping: 0.5 });
    const halfTurnS = 0.5 / Math.sqrt(0.75);
    expect(run(halfTurnS, 60)).toBeCloseTo(-Math.exp((-Math.PI * 0.5) / Math.sqrt(0.75)), 9);
  });

  test('above damping 1 creeps as the sum of two decays', () => {
    const { run } = start({ frequencyHz: 1, damping: 2 });
    const [a, b] = [2 * Math.PI * (2 - Math.sqrt(3)), 2 * Math.PI * (2 + Math.sqrt(3))];
    expect(run(0.4, 3)).toBeCloseTo((b * Math.exp(-a * 0.4) - a * Math.exp(-b * 0.4)) / (b - a), 9);
  });

  test.each([0, 0.3, 0.999999, 1, 1.000001, 3])('is the same in one step as in a thousand, at damping %d', (damping) => {
    const one = start({ frequencyHz: 30, damping }).run(1.7, 1);
    expect(one).toBeCloseTo(start({ frequencyHz: 30, damping }).run(1.7, 1000), 6);
  });

  test.each([0.3, 1, 5])('comes to rest after a frame of an hour, at damping %d', (damping) => {
    const { fake, run } = start({ frequencyHz: 30, damping });
    expect([run(3600, 1), fake.ctx.outputs.speed.value]).toEqual([expect.closeTo(0, 9), expect.closeTo(0, 9)]);
  });

  test('a reset puts it to rest at its number', () => {
    const { fake, node, run } = start({ frequencyHz: 1, damping: 0.2 });
    run(0.1, 3);
    node.reset?.();
    expect([run(0.5, 5), fake.ctx.outputs.speed.value]).toEqual([0, 0]);
  });
});
