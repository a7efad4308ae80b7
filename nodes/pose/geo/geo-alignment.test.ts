import { describe, expect, test } from '@jest/globals';
import { createRandom } from '../../../export/runtime/random.ts';
import { createGeoAlignment, type GeoAlignment } from './geo-alignment.ts';

const RAD = Math.PI / 180;
const TRACKED = { moveM2PerS: 0.02 ** 2 / 60, turnRad2PerS: RAD ** 2 / 60 };

/** Normal numbers (Box–Muller). */
function normals(seed: number, name: string) {
  const random = createRandom(seed, name);
  return () => Math.sqrt(-2 * Math.log(1 - random.next())) * Math.cos(2 * Math.PI * random.next());
}

/** Errors of satellites or a compass: they keep their direction for a time, first-order Gauss–Markov. */
function slowError(normal: () => number, sigma: number, timeS: number) {
  let value = sigma * normal();
  return (deltaS: number) => {
    const keep = Math.exp(-deltaS / timeS);
    value = value * keep + sigma * Math.sqrt(1 - keep * keep) * normal();
    return value;
  };
}

const SIGMA_M = 2;
const SIGMA_RAD = 8 * RAD;

/** A visitor who walks around for two minutes while tracking drifts; what the filter says of a point 30 m away, and what is true. */
function walk(seed: number, compass: boolean, steps = 120) {
  const normal = normals(seed, 'geo');
  const [errorE, errorN] = [slowError(normal, SIGMA_M, 20), slowError(normal, SIGMA_M, 20)];
  const errorTurn = slowError(normal, SIGMA_RAD, 60);
  const alignment = createGeoAlignment(() => TRACKED);
  let truth = 2.5 + normal();
  let [east, north] = [3, -4];
  let course = normal();
  for (let s = 0; s < steps; s++) {
    alignment.place(east + errorE(1), north + errorN(1), SIGMA_M, s);
    if (compass) alignment.turn(truth + errorTurn(1), SIGMA_RAD, s);
    // What the session says of a step of 0.7 m over the ground.
    course += 0.3 * normal();
    const [right, ahead] = [0.7 * Math.sin(course), 0.7 * Math.cos(course)];
    alignment.move(right, ahead, 1);
    east += right * Math.cos(truth) + ahead * Math.sin(truth);
    north += ahead * Math.cos(truth) - right * Math.sin(truth);
    truth += RAD * Math.sqrt(1 / 60) * normal();
  }
  return { alignment, truth, east, north };
}

/** How far a point is from where it belongs, whose offset from the device is computed by the estimate. */
function missM({ alignment, truth, east, north }: ReturnType<typeof walk>, target: readonly [number, number]) {
  const [dE, dN] = [target[0] - alignment.eastM, target[1] - alignment.northM];
  const turn = truth - alignment.northRad;
  // In world space by the estimate, and back to the earth by the truth.
  const [atE, atN] = [dE * Math.cos(turn) + dN * Math.sin(turn), dN * Math.cos(turn) - dE * Math.sin(turn)];
  return { missM: Math.hypot(east + atE - target[0], north + atN - target[1]), errorM: alignment.errorM(dE, dN) };
}

const wrap = (rad: number) => Math.atan2(Math.sin(rad), Math.cos(rad));

describe('the alignment of world space with the earth', () => {
  test.each([true, false])('states errors that hold in 95 %% of walks (compass: %s)', (compass) => {
    let [within, turnWithin, counted] = [0, 0, 0];
    for (let seed = 1001; seed <= 1400; seed++) {
      const walked = walk(seed, compass);
      const { alignment, truth } = walked;
      if (!alignment.isTurned) continue;
      counted++;
      const { missM: miss, errorM } = missM(walked, [30, 10]);
      if (miss <= errorM) within++;
      if (Math.abs(wrap(alignment.northRad - truth)) <= alignment.turnErrorRad) turnWithin++;
    }
    expect(counted).toBeGreaterThan(compass ? 399 : 300);
    expect(within / counted).toBeGreaterThan(0.92);
    expect(turnWithin / counted).toBeGreaterThan(0.92);
  });

  test('a walk of two minutes brings a point nearer to its place than one position and one reading of the compass', () => {
    const medianM = (steps: number): number => {
      const misses = Array.from({ length: 200 }, (_, seed) => missM(walk(seed, true, steps), [30, 10]).missM).sort((a, b) => a - b);
      return misses[100] ?? Number.NaN;
    };
    expect(medianM(120)).toBeLessThan(0.75 * medianM(1));
  });

  test('knows north without a compass only after a walk that is far longer than the errors', () => {
    const short = walk(3, false, 8).alignment;
    expect([short.isPlaced, short.isTurned, short.errorM(10, 0)]).toEqual([true, false, Number.POSITIVE_INFINITY]);
    expect(walk(3, false, 200).alignment.isTurned).toBe(true);
  });

  test('the error of a far point grows with the error of north, that of a near one does not', () => {
    const alignment = createGeoAlignment(() => TRACKED);
    alignment.place(0, 0, 2, 0);
    alignment.turn(0.3, 0.1, 0);
    // 95 % of a normal distribution of two numbers are within 2.448 standard deviations.
    expect(alignment.errorM(0, 0)).toBeCloseTo(2.448 * 2, 3);
    expect(alignment.errorM(100, 0)).toBeCloseTo(2.448 * Math.hypot(2, 10), 3);
    expect(alignment.turnErrorRad).toBeCloseTo(0.196, 3);
  });

  test('positions of the same minute tell little more than one', () => {
    const alignment = createGeoAlignment(() => TRACKED);
    const errorAfter = (seconds: number): number => {
      alignment.reset();
      alignment.turn(0, 0.001, 0);
      for (let s = 0; s <= seconds; s++) alignment.place(0, 0, 4, s);
      return alignment.errorM(0, 0) / (2.448 * 4);
    };
    expect(errorAfter(10)).toBeGreaterThan(0.75);
    // After ten minutes as 16 independent ones: one at the start, and one each 40 s.
    expect(errorAfter(600)).toBeCloseTo(1 / Math.sqrt(16), 2);
  });

  test('keeps the place and the view’s direction where world space jumps, and allows for an error', () => {
    const alignment: GeoAlignment = createGeoAlignment(() => TRACKED);
    alignment.place(5, 6, 2, 0);
    alignment.turn(1, 0.1, 0);
    const before = alignment.turnErrorRad;
    alignment.jump(1 + Math.PI);
    expect([alignment.eastM, alignment.northM]).toEqual([5, 6]);
    expect(alignment.northRad).toBeCloseTo(1 - Math.PI, 10);
    expect(alignment.turnErrorRad).toBeGreaterThan(before);
  });
});
