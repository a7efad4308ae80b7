import { describe, expect, test } from '@jest/globals';
import { type FakeContext, fakeContext } from '../../../tests/support/node-context.ts';
import type { NodeRuntime } from '../../kit/runtime.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { speed?: number; loopS?: number } = {}): {
  fake: FakeContext<typeof definition>;
  node: NodeRuntime;
  step(deltaS: number): number;
} {
  const fake = fakeContext(definition, { params });
  const node = create(fake.ctx);
  return {
    fake,
    node,
    step: (deltaS) => {
      fake.tick(deltaS);
      node.update({} as never);
      return fake.ctx.outputs.seconds.value;
    },
  };
}

describe('time', () => {
  test('is that of the session', () => {
    const { step } = start();
    expect([step(0.5), step(0.25)]).toEqual([0.5, 0.75]);
  });

  test('is the same for a single frame as in a sequence', () => {
    expect(start({ speed: 3 }).step(0.75)).toBe(2.25);
  });

  test('continues from the current time when the speed changes', () => {
    const { fake, step } = start({ speed: 1 });
    step(2);
    fake.set('speed', 10);
    expect(step(0)).toBe(2);
    expect(step(0.5)).toBe(7);
    fake.set('speed', -2);
    expect([step(0), step(1)]).toEqual([7, 5]);
  });

  test('wraps at the end of its loop, also backwards', () => {
    expect(start({ loopS: 4 }).step(9.5)).toBeCloseTo(1.5, 12);
    expect(start({ loopS: 4, speed: -1 }).step(1)).toBeCloseTo(3, 12);
    expect(start({ loopS: 0 }).step(9.5)).toBe(9.5);
  });

  test('is the session clock again after a reset', () => {
    const { fake, node, step } = start({ speed: 1 });
    step(2);
    fake.set('speed', 10);
    step(1);
    node.reset?.();
    expect(step(0)).toBe(30);
  });
});
