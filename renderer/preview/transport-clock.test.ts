import { expect, test } from '@jest/globals';
import { createManualClock } from '../../export/runtime/clock.ts';
import { createTransportClock } from './transport-clock.ts';

function createRun() {
  const base = createManualClock();
  const clock = createTransportClock(base, () => {});
  const times: number[] = [];
  const tick = (timeS: number) => {
    times.push(Math.round(timeS * 1000) / 1000);
    clock.requestFrame(tick);
  };
  clock.requestFrame(tick);
  return { base, clock, times };
}

test('runs with the display while playing, and stands while held', async () => {
  const { base, clock, times } = createRun();
  base.advance(0.1);
  base.advance(0.1);
  clock.setPlaying(false);
  times.length = 0;
  for (let i = 0; i < 10; i++) {
    base.advance(0.1);
    await Promise.resolve();
  }
  expect(new Set(times)).toEqual(new Set([0.2]));
  // One at once, then a few a second.
  expect(times.length).toBeGreaterThanOrEqual(3);
  expect(times.length).toBeLessThanOrEqual(5);
  clock.setPlaying(true);
  base.advance(0.1);
  expect(times.at(-1)).toBe(0.3);
});

test('takes no leap after the page was hidden', () => {
  const { base, times } = createRun();
  base.advance(0.1);
  base.advance(60);
  base.advance(0.1);
  expect(times).toEqual([0.1, 0.6, 0.7]);
});

test('held, a step moves time on once, and a wake asks for a frame without moving it', async () => {
  const { base, clock, times } = createRun();
  clock.setPlaying(false);
  base.advance(0.01);
  times.length = 0;
  clock.step(0.04);
  base.advance(0.01);
  base.advance(0.01);
  expect(times).toEqual([0.04]);
  expect([clock.asked, clock.idle]).toEqual([true, false]);
  clock.wake();
  base.advance(0.01);
  expect(times).toEqual([0.04, 0.04]);
  base.advance(1);
  await Promise.resolve();
  base.advance(0.01);
  expect([times.length, clock.asked, clock.idle]).toEqual([3, false, true]);
});
