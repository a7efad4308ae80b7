import { describe, expect, test } from '@jest/globals';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(params: { periodS?: number; atOnce?: boolean }) {
  const fake = fakeContext(definition, { params });
  const node = create(fake.ctx);
  const frame = (deltaS: number): number[] => {
    fake.tick(deltaS);
    node.update({} as never);
    return pulseNumbers(fake.ctx.outputs.pulse);
  };
  return { fake, node, frame };
}

describe('every', () => {
  test('gives a pulse each time its period is over', () => {
    const { frame } = start({ periodS: 0.3 });
    frame(0);
    expect(Array.from({ length: 9 }, () => frame(0.1))).toEqual([[], [], [1], [], [], [2], [], [], [3]]);
  });

  test('or begins with one', () => {
    const { frame } = start({ periodS: 0.2, atOnce: true });
    expect([frame(0), frame(0.1), frame(0.1), frame(0.1), frame(0.1)]).toEqual([[1], [], [2], [], [3]]);
  });

  test.each([10, 24, 60, 144])('gives as many within an hour, at %d frames per second', (rate) => {
    const { frame } = start({ periodS: 0.7 });
    let count = frame(0).length;
    for (let i = 0; i < 3600 * rate; i++) count += frame(1 / rate).length;
    expect(count).toBe(Math.floor(3600 / 0.7));
  });

  test('gives several in a long frame, at most as many as go through', () => {
    const { frame } = start({ periodS: 0.1 });
    frame(0);
    expect(frame(0.35)).toEqual([1, 2, 3]);
    expect(frame(1000)).toHaveLength(16);
    expect(frame(0.1)).toHaveLength(1);
  });

  test('goes on from where it is when the period changes', () => {
    const { fake, frame } = start({ periodS: 1 });
    frame(0);
    frame(0.5);
    fake.set('periodS', 0.2);
    expect([frame(0), frame(0.05), frame(0.05)]).toEqual([[], [], [1]]);
  });

  test('gives none without a period, and begins anew after a reset', () => {
    const { fake, node, frame } = start({ periodS: 0 });
    expect([frame(0), frame(10)]).toEqual([[], []]);
    fake.set('periodS', 1);
    node.reset?.();
    expect([frame(5), frame(0.9), frame(0.1)]).toEqual([[], [], [1]]);
  });
});
