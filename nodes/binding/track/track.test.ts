import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { type Easing, ease } from '../../kit/ease.ts';
import { type Repeat, timeInTrack } from '../../kit/track-time.ts';
import { create } from './runtime.ts';

interface Key {
  readonly timeS: number;
  readonly value: readonly number[];
  readonly easing?: Easing;
}

/** What a param bound to the track has at a time. */
function play(
  keys: readonly Key[],
  repeat: Repeat,
  timesS: readonly number[],
  size = 1,
  limits?: readonly number[],
): (number | number[])[] {
  const clock = { timeS: 0, frame: 0 };
  const value: { value: number | Float64Array } = { value: size === 1 ? 0 : new Float64Array(size) };
  const config = {
    times: keys.map(({ timeS }) => timeS),
    values: keys.flatMap((key) => key.value),
    easings: keys.map(({ easing = 'linear' }) => easing).join(' '),
    ...(limits ? { limits } : {}),
    repeat,
  };
  const { update } = create({ outputs: { value }, config, clock });
  return timesS.map((timeS) => {
    clock.timeS = timeS;
    update({} as never);
    return typeof value.value === 'number' ? value.value : [...value.value];
  });
}

const UP: readonly Key[] = [
  { timeS: 1, value: [10] },
  { timeS: 3, value: [20] },
  { timeS: 4, value: [0] },
];

describe('a track', () => {
  test('interpolates between keyframes and is constant before and after them', () => {
    expect(play(UP, 'once', [0, 1, 1.5, 2, 3, 3.5, 4, 99])).toEqual([10, 10, 12.5, 15, 20, 10, 0, 0]);
  });

  test('loop restarts at the first keyframe', () => {
    expect(play(UP, 'loop', [0, 1, 2, 4, 5, 7, 7.5, 302])).toEqual([10, 10, 15, 10, 15, 10, 12.5, 15]);
  });

  test('ping-pong reverses at both ends', () => {
    expect(play(UP, 'mirror', [0, 1, 3, 4, 4.5, 5, 6, 7, 8])).toEqual([10, 10, 20, 0, 10, 20, 15, 10, 15]);
  });

  test('interpolates all components of a vector', () => {
    const keys: Key[] = [
      { timeS: 0, value: [0, 1, -1] },
      { timeS: 2, value: [2, 1, 1] },
    ];
    expect(play(keys, 'once', [0, 0.5, 2], 3)).toEqual([
      [0, 1, -1],
      [0.5, 1, -0.5],
      [2, 1, 1],
    ]);
  });

  test('each keyframe has its own easing, and a step holds until the next keyframe', () => {
    const keys: Key[] = [
      { timeS: 0, value: [0], easing: 'step' },
      { timeS: 1, value: [1], easing: 'linear' },
      { timeS: 2, value: [3], easing: 'step' },
    ];
    expect(play(keys, 'once', [0.999, 1, 1.5, 2, 5])).toEqual([0, 1, 2, 3, 3]);
  });

  test('control points can overshoot, up to the limits of the param', () => {
    const keys: Key[] = [
      { timeS: 0, value: [0, 0], easing: [0.34, 1.56, 0.64, 1] },
      { timeS: 1, value: [1, -1] },
    ];
    const free = play(keys, 'once', [0.5, 1], 2) as number[][];
    expect(free[0]?.[0]).toBeGreaterThan(1.05);
    expect(free[0]?.[1]).toBe(-(free[0]?.[0] ?? 0));
    expect(free[1]).toEqual([1, -1]);
    expect(play(keys, 'once', [0.5], 2, [0, 1, -Number.MAX_VALUE, Number.MAX_VALUE])).toEqual([[1, free[0]?.[1]]]);
  });

  test('with one keyframe is constant', () => {
    for (const repeat of ['once', 'loop', 'mirror'] as const)
      expect(play([{ timeS: 1, value: [7] }], repeat, [0, 1, 2])).toEqual([7, 7, 7]);
  });

  test('equals the keyframes at their times, and is between their values in between', () => {
    const keys = fc
      .uniqueArray(fc.integer({ min: 0, max: 1000 }), { minLength: 1, maxLength: 12 })
      .chain((times) =>
        fc.tuple(
          fc.constant(times.sort((a, b) => a - b)),
          fc.array(
            fc.tuple(
              fc.double({ min: -5, max: 5, noNaN: true }),
              fc.constantFrom<Easing>('linear', 'step', 'ease-in', 'ease-out', 'ease-in-out', [0.9, 0, 0.1, 1], [0, 1, 1, 0]),
            ),
            {
              minLength: times.length,
              maxLength: times.length,
            },
          ),
        ),
      )
      .map(([times, rest]) =>
        times.map((timeS, i): Key => ({ timeS, value: [(rest[i]?.[0] ?? 0) + 0], easing: rest[i]?.[1] ?? 'linear' })),
      );
    fc.assert(
      fc.property(keys, fc.double({ min: 0, max: 1, noNaN: true }), (track, at) => {
        for (const [i, { timeS, value }] of track.entries()) {
          expect(play(track, 'once', [timeS])).toEqual(value);
          const next = track[i + 1];
          if (!next) continue;
          const [between] = play(track, 'once', [timeS + (next.timeS - timeS) * at]) as [number];
          const [low, high] = [...value, ...next.value].sort((a, b) => a - b) as [number, number];
          expect(between).toBeGreaterThanOrEqual(low - 1e-12);
          expect(between).toBeLessThanOrEqual(high + 1e-12);
        }
      }),
      { seed: 1, numRuns: 300 },
    );
  });

  test('maps to the same time in each iteration', () => {
    const times = Float64Array.of(2, 5);
    fc.assert(
      fc.property(fc.double({ min: 0, max: 3, noNaN: true }), fc.nat(50), (x, rounds) => {
        expect(timeInTrack(2 + x + 6 * rounds, times, 'mirror')).toBeCloseTo(2 + x, 9);
        expect(timeInTrack(2 + 6 - x + 6 * rounds, times, 'mirror')).toBeCloseTo(2 + x, 9);
        if (x > 1e-6 && x < 3 - 1e-6) expect(timeInTrack(2 + x + 3 * rounds, times, 'loop')).toBeCloseTo(2 + x, 9);
      }),
      { seed: 1, numRuns: 200 },
    );
  });
});

describe('easing', () => {
  /** css-easing-1, §2.2, worked out by halving alone: slow and plain. */
  function bezier(x1: number, x2: number, x: number): number {
    let [low, high] = [0, 1];
    for (let i = 0; i < 200; i++) {
      const t = (low + high) / 2;
      if (3 * (1 - t) ** 2 * t * x1 + 3 * (1 - t) * t ** 2 * x2 + t ** 3 < x) low = t;
      else high = t;
    }
    return 3 * (1 - low) * low ** 2 + low ** 3;
  }

  test.each([
    ['ease-in', 0.42, 1],
    ['ease-out', 0, 0.58],
    ['ease-in-out', 0.42, 0.58],
  ] as const)('%s is the curve that CSS calls so', (easing, x1, x2) => {
    let before = 0;
    for (let i = 0; i <= 1000; i++) {
      const eased = ease(easing, i / 1000);
      expect(eased).toBeCloseTo(bezier(x1, x2, i / 1000), 7);
      expect(eased).toBeGreaterThanOrEqual(before);
      before = eased;
    }
    expect([ease(easing, 0), ease(easing, 1)]).toEqual([0, 1]);
  });
});
