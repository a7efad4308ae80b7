import { describe, expect, test } from '@jest/globals';
import { planFrames, rateOf } from './render-frames.ts';

/** Ten a second. */
const FRAMES = { timesS: Array.from({ length: 36 }, (_, i) => i / 10), durationS: 3.6 };
const RANGE = { from: 5, to: 7 };

const kept = (plan: ReturnType<typeof planFrames>) => plan.filter(({ keep }) => keep).map(({ number, timeS }) => [number, timeS]);
const earlier = (plan: ReturnType<typeof planFrames>) => plan.filter(({ keep }) => !keep).map(({ timeS }) => timeS);

describe('the frames to render', () => {
  test('are the recording’s own, by their numbers, after the one before', () => {
    const plan = planFrames(FRAMES, RANGE, null, false);
    expect(kept(plan)).toEqual([
      [5, 0.5],
      [6, 0.6],
      [7, 0.7],
    ]);
    expect(earlier(plan)).toEqual([0.4]);
    expect(earlier(planFrames(FRAMES, { from: 0, to: 1 }, null, false))).toEqual([]);
  });

  test('come after all before them where something remembers these', () => {
    expect(earlier(planFrames(FRAMES, RANGE, null, true))).toEqual([0, 0.1, 0.2, 0.3, 0.4]);
    expect(earlier(planFrames(FRAMES, RANGE, 20, true))).toHaveLength(10);
  });

  test('at another rate fill the same time, counted from 0', () => {
    const twice = planFrames(FRAMES, RANGE, 20, false);
    expect(kept(twice).map(([, timeS]) => timeS)).toEqual([0.5, 0.55, 0.6, 0.65, 0.7, 0.75].map((s) => expect.closeTo(s, 9)));
    expect(kept(twice).map(([number]) => number)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(earlier(twice)).toEqual([expect.closeTo(0.45, 9)]);
    expect(kept(planFrames(FRAMES, { from: 0, to: 35 }, 24, false))).toHaveLength(87);
    expect(kept(planFrames(FRAMES, { from: 3, to: 3 }, 1, false))).toHaveLength(1);
  });

  test('have the rate that the recording has', () => {
    expect(rateOf(FRAMES)).toBe(10);
    expect(rateOf({ timesS: [0, 1 / 29.97], durationS: 2 / 29.97 })).toBe(29.97);
  });
});
