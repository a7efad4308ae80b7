import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(delayS: number, first = -1) {
  const fake = fakeContext(definition, { params: { delayS, start: first } });
  const node = create(fake.ctx);
  const frame = (deltaS: number, number: number): number => {
    fake.tick(deltaS);
    node.update({} as never);
    fake.set('number', number);
    node.remember?.();
    return fake.ctx.outputs.result.value;
  };
  return { fake, node, frame };
}

describe('delay', () => {
  test('of 0 gives the number of the previous frame, however long that took', () => {
    const { frame } = start(0);
    expect([frame(0.01, 5), frame(0.5, 6), frame(0.001, 7), frame(1, 8)]).toEqual([-1, 5, 6, 7]);
  });

  test.each([24, 60, 144])('of half a second gives a ramp half a second late, at %d frames per second', (rate) => {
    const { fake, frame } = start(0.5);
    for (let i = 1; i < 3 * rate; i++) {
      const late = frame(1 / rate, i / rate);
      if (i > rate) expect(late).toBeCloseTo(fake.ctx.clock.timeS - 0.5, 9);
    }
  });

  test('outputs the oldest number until the delay has passed', () => {
    const { frame } = start(10);
    expect([frame(0.1, 5), frame(0.1, 6), frame(0.1, 7)]).toEqual([-1, 5, 5]);
  });

  test('keeps ten seconds at 144 frames per second', () => {
    const { frame } = start(10);
    let late = 0;
    for (let i = 1; i <= 3000; i++) late = frame(1 / 144, i);
    expect(late).toBeCloseTo(3000 - 1440, 6);
  });

  test('two frames at the same time count as one, and a seek backwards clears the history', () => {
    const { fake, frame } = start(0);
    frame(0.1, 5);
    frame(0, 6);
    expect(frame(0.1, 7)).toBe(6);
    fake.tick(-5);
    frame(0, 9);
    expect(frame(0.1, 1)).toBe(9);
  });

  test('outputs the start value after a reset', () => {
    const { node, frame } = start(0);
    frame(0.1, 5);
    node.reset?.();
    expect([frame(0.1, 6), frame(0.1, 7)]).toEqual([-1, 6]);
  });
});
