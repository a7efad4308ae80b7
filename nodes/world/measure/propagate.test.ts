import { describe, expect, test } from '@jest/globals';
import { createRandom } from '../../../export/runtime/random.ts';
import { measureBox, measurePolygon, measurePolyline, measureRectangle } from './extents.ts';
import {
  createSeenPoint,
  INTERVAL_95,
  type Measured,
  measureAngle,
  measureDistance,
  measureHeight,
  type PointNoise,
  type SeenPoint,
  setNoise,
} from './propagate.ts';

type Vector = readonly [number, number, number];
type Measure = (points: readonly SeenPoint[], out: Measured) => void;

/** 0.73 cm along the ray, at any distance. */
const CONSTANT: PointNoise = { alongM: 0.0073, referenceM: 0.4, growth: 'none', acrossRad: 0 };
/** The noise that the node starts with. */
const GROWING: PointNoise = { alongM: 0.0073, referenceM: 0.4, growth: 'square', acrossRad: 0.0009 };
const EYE: Vector = [0, 0, 0];

function seen(position: Vector, noise: PointNoise, eye: Vector = EYE): SeenPoint {
  const point = createSeenPoint();
  point.positionM.set(position);
  setNoise(point, eye, noise);
  return point;
}

const at = (points: readonly SeenPoint[], i: number) => points[i] ?? createSeenPoint();
const distance: Measure = (points, out) => measureDistance(at(points, 0), at(points, 1), out);
const angle: Measure = (points, out) => measureAngle(at(points, 0), at(points, 1), at(points, 2), out);
const height: Measure = (points, out) => measureHeight(at(points, 0), out);

const polyline: Measure = (points, out) => measurePolyline(points, points.length, out);
const rectangle: Measure = (points, out) => measureRectangle(at(points, 0), at(points, 1), at(points, 2), out);
const polygon: Measure = (points, out) => measurePolygon(points, points.length, out);
const box: Measure = (points, out) => measureBox(at(points, 0), at(points, 1), at(points, 2), at(points, 3), out);

function measured(measure: Measure, positions: readonly Vector[], noise: PointNoise, eye: Vector = EYE): Measured {
  const out = { value: 0, sigma: 0 };
  measure(
    positions.map((position) => seen(position, noise, eye)),
    out,
  );
  return out;
}

/** 20 cm, in the middle of the view, at 40 cm. */
const ACROSS: readonly Vector[] = [
  [-0.1, 0, -0.4],
  [0.1, 0, -0.4],
];
const ALONG: readonly Vector[] = [
  [0, 0, -0.4],
  [0, 0, -0.6],
];

describe('the noise of a point', () => {
  test('grows with the square of the distance along the ray, and with the distance across', () => {
    // At twice the reference distance: 4 · 0.73 cm along, 0.8 m · 0.0009 across.
    const point = seen([0, 0, -0.8], GROWING);
    expect([...point.ray]).toEqual([0, 0, -1]);
    expect(point.alongM).toBeCloseTo(0.0292, 9);
    expect(point.acrossM).toBeCloseTo(0.00072, 9);
    expect(seen([0, 0, -0.8], CONSTANT).alongM).toBe(0.0073);
  });

  test('is none at the eye', () => {
    const point = seen(EYE, GROWING);
    expect([point.alongM, point.acrossM, ...point.ray]).toEqual([0, 0, 0, 0, 0]);
  });
});

describe('propagation to first order', () => {
  test('of a ruler across the view: each end contributes the part of the ray that lies along the ruler', () => {
    // 0.73 cm · 10 / √(10² + 40²) · √2
    const { value, sigma } = measured(distance, ACROSS, CONSTANT);
    expect([value, sigma]).toEqual([expect.closeTo(0.2, 9), expect.closeTo(0.0025039, 6)]);
  });

  test('of a ruler along the view: 0.73 cm · √2', () => {
    const { value, sigma } = measured(distance, ALONG, CONSTANT);
    expect([value, sigma]).toEqual([expect.closeTo(0.2, 9), expect.closeTo(0.0103238, 6)]);
    // With growth, the far end has (60 / 40)² = 2.25 as much: 0.73 cm · √(1 + 2.25²).
    expect(measured(distance, ALONG, { ...GROWING, acrossRad: 0 }).sigma).toBeCloseTo(0.0179742, 6);
  });

  test('of a height: the vertical part of the ray', () => {
    // The ray (0.3, -0.4, 0) is 0.5 m long: 0.73 cm · 0.8 along, 0.5 m · 0.01 · 0.6 across.
    const { value, sigma } = measured(height, [[0.3, 1, 0]], { ...CONSTANT, acrossRad: 0.01 }, [0, 1.4, 0]);
    expect(value).toBe(1);
    expect(sigma).toBeCloseTo(Math.hypot(0.00584, 0.003), 9);
  });

  test('of a right angle', () => {
    // The arms are 0.2 m long. The derivatives are -5 x by A, 5 z by C and 5 x - 5 z by B. Along the rays that is 0 for A, which lies
    // behind B; 5 · 0.4 / √(0.2² + 0.4²) = 4.4721 for C; and 5 for B: 0.0073 · √(20 + 25).
    const { value, sigma } = measured(
      angle,
      [
        [0, 0, -0.6],
        [0, 0, -0.4],
        [0.2, 0, -0.4],
      ],
      CONSTANT,
    );
    expect([value, sigma]).toEqual([expect.closeTo(Math.PI / 2, 9), expect.closeTo(0.0489699, 6)]);
  });

  test('of a straight angle: the parts across the line', () => {
    // A and C: the rays (±0.1, 0, -0.4) lie across the line by 4 / √17, so 0.0073 · √(16 / 17) / 0.1 each. B: 0.0073 · (1 / 0.1 + 1 / 0.1).
    const { value, sigma } = measured(
      angle,
      [
        [-0.1, 0, -0.4],
        [0, 0, -0.4],
        [0.1, 0, -0.4],
      ],
      CONSTANT,
    );
    expect(value).toBeCloseTo(Math.PI, 9);
    expect(sigma).toBeCloseTo(0.073 * Math.sqrt((2 * 16) / 17 + 4), 9);
  });

  test('gives finite numbers where points coincide', () => {
    const point: Vector = [0, 0, -0.4];
    expect(measured(distance, [point, point], CONSTANT)).toEqual({ value: 0, sigma: expect.closeTo(0.0103238, 6) });
    expect(measured(angle, [point, point, [0, 1, 0]], CONSTANT)).toEqual({ value: 0, sigma: Math.PI });
  });
});

/** An L, 4 cm² · 3 with its sides along x and y, at 40 cm. */
const L_SHAPE: readonly Vector[] = [
  [0, 0, -0.4],
  [0.04, 0, -0.4],
  [0.04, 0.02, -0.4],
  [0.02, 0.02, -0.4],
  [0.02, 0.04, -0.4],
  [0, 0.04, -0.4],
];

describe('areas, volumes and lines', () => {
  test('have their values, also where edges turn inwards or the opposite side is taken beside its corner', () => {
    expect(measured(polygon, L_SHAPE, CONSTANT).value).toBeCloseTo(0.0012, 12);
    const corners: Vector[] = [
      [0, 0, -1],
      [0.3, 0, -1],
      [0.7, 0.2, -1],
    ];
    expect(measured(rectangle, corners, CONSTANT).value).toBeCloseTo(0.06, 12);
    expect(measured(box, [...corners, [5, 5, -1.5]], CONSTANT).value).toBeCloseTo(0.03, 12);
    expect(measured(box, [...corners, [5, 5, -0.5]], CONSTANT).value).toBeCloseTo(0.03, 12);
    expect(measured(polyline, corners, CONSTANT).value).toBeCloseTo(0.3 + Math.hypot(0.4, 0.2), 12);
  });

  test('have the deviation that finite differences give', () => {
    const positions: readonly Vector[] = [
      [-0.1, 0.05, -0.4],
      [0.12, 0, -0.5],
      [0.1, 0.2, -0.45],
      [-0.05, 0.15, -0.7],
    ];
    for (const measure of [polyline, rectangle, polygon, box]) {
      const exact = positions.map((position) => seen(position, GROWING));
      const value = (points: readonly SeenPoint[]) => {
        const out = { value: 0, sigma: 0 };
        measure(points, out);
        return out.value;
      };
      let squared = 0;
      exact.forEach((point, p) => {
        const gradient = [0, 1, 2].map((axis) => {
          const shifted = (by: number) => {
            const copy = positions.map((position) => seen(position, GROWING));
            const positionM = copy[p]?.positionM ?? new Float64Array(3);
            positionM[axis] = (positionM[axis] ?? 0) + by;
            return value(copy);
          };
          return (shifted(1e-6) - shifted(-1e-6)) / 2e-6;
        });
        const along = gradient.reduce((sum, each, axis) => sum + each * (point.ray[axis] ?? 0), 0);
        const all = gradient.reduce((sum, each) => sum + each * each, 0);
        squared += (along * point.alongM) ** 2 + (all - along * along) * point.acrossM ** 2;
      });
      expect(measured(measure, positions, GROWING).sigma).toBeCloseTo(Math.sqrt(squared), 7);
    }
  });

  test('are finite where points coincide', () => {
    const point: Vector = [0, 0, -0.4];
    for (const measure of [polyline, rectangle, polygon, box]) {
      const { value, sigma } = measured(measure, [point, point, point, point], GROWING);
      expect([value, Number.isFinite(sigma)]).toEqual([0, true]);
    }
  });
});

const SAMPLES = 2000;

/** What 2,000 noisy measurements of the same points give. */
function sample(measure: Measure, positions: readonly Vector[], noise: PointNoise, eye: Vector) {
  const random = createRandom(7, 'measure');
  const normal = () => Math.sqrt(-2 * Math.log(1 - random.next())) * Math.cos(2 * Math.PI * random.next());
  const exact = positions.map((position) => seen(position, noise, eye));
  const truth = { value: 0, sigma: 0 };
  measure(exact, truth);
  const points = positions.map(createSeenPoint);
  const out = { value: 0, sigma: 0 };
  let sum = 0;
  let squares = 0;
  let held = 0;
  for (let n = 0; n < SAMPLES; n++) {
    points.forEach((point, p) => {
      const { positionM, ray, alongM, acrossM } = at(exact, p);
      const shift = [normal() * acrossM, normal() * acrossM, normal() * acrossM];
      const excess = shift.reduce((total, each, i) => total + each * (ray[i] ?? 0), 0);
      const along = normal() * alongM - excess;
      point.positionM.set(positionM.map((x, i) => x + (shift[i] ?? 0) + along * (ray[i] ?? 0)));
      // As the node does it: the noise is estimated at the point that was found.
      setNoise(point, eye, noise);
    });
    measure(points, out);
    const error = out.value - truth.value;
    sum += error;
    squares += error * error;
    if (Math.abs(error) <= INTERVAL_95 * out.sigma) held++;
  }
  const bias = sum / SAMPLES;
  return { bias, spread: Math.sqrt(squares / SAMPLES - bias * bias), propagated: truth.sigma, held: held / SAMPLES };
}

/** How far a result is off if all its points are off by 0.05 cm away from their middle. */
function limitOf(measure: Measure, positions: readonly Vector[]): number {
  if (measure === angle) return (0.5 * Math.PI) / 180;
  if (measure !== rectangle && measure !== polygon && measure !== box) return 0.0005;
  const middle = [0, 1, 2].map((i) => positions.reduce((sum, position) => sum + (position[i] ?? 0), 0) / positions.length);
  const away = positions.map((position): Vector => {
    const ray = position.map((x, i) => x - (middle[i] ?? 0));
    const scale = 1 + 0.0005 / Math.hypot(...ray);
    return ray.map((x, i) => (middle[i] ?? 0) + x * scale) as unknown as Vector;
  });
  return Math.abs(measured(measure, away, CONSTANT).value - measured(measure, positions, CONSTANT).value);
}

/** A table seen from its edge. */
const EDGE: Vector = [0, 1, 0.3];
const TABLE: readonly Vector[] = [
  [-0.15, 0.75, 0],
  [0.1, 0.75, 0.05],
  [0.15, 0.75, -0.2],
];

/** The top of the table, and its outline with a corner cut off. */
const TOP: readonly Vector[] = [...TABLE.slice(0, 2), [0.15, 0.75, -0.2]];
const OUTLINE: readonly Vector[] = [
  [-0.15, 0.75, 0],
  [0.1, 0.75, 0.05],
  [0.15, 0.75, -0.2],
  [0, 0.75, -0.25],
  [-0.12, 0.75, -0.18],
];

describe.each<[string, Measure, readonly Vector[], PointNoise, Vector]>([
  ['a ruler across the view', distance, ACROSS, CONSTANT, EYE],
  ['a ruler along the view', distance, ALONG, CONSTANT, EYE],
  ['a ruler across the view, with the noise of the node', distance, ACROSS, GROWING, EYE],
  ['the side of a table, with the noise of the node', distance, TABLE, GROWING, EDGE],
  ['the angle of a table, with the noise of the node', angle, TABLE, GROWING, EDGE],
  ['the height of a table, with the noise of the node', height, TABLE, GROWING, EDGE],
  ['a line along two edges of a table', polyline, TABLE, CONSTANT, EDGE],
  ['the top of a table', rectangle, TOP, GROWING, EDGE],
  ['the top of a table with five corners', polygon, OUTLINE, GROWING, EDGE],
  ['a polygon that faces the viewer', polygon, L_SHAPE.map(([x, y, z]): Vector => [4 * x, 4 * y, z]), CONSTANT, EYE],
  ['a box on a table', box, [...TOP, [0.1, 0.95, 0]], GROWING, EDGE],
])('2,000 measurements of %s', (_name, measure, positions, noise, eye) => {
  const { bias, spread, propagated, held } = sample(measure, positions, noise, eye);

  test('spread within 10 % of the propagated error', () => {
    expect(spread / propagated).toBeGreaterThan(0.9);
    expect(spread / propagated).toBeLessThan(1.1);
  });

  test('have a bias below 0.05 cm, 0.5° of an angle, or 0.05 cm on each side of an area or a box', () => {
    expect(Math.abs(bias)).toBeLessThan(limitOf(measure, positions));
  });

  test('are in their 95 % interval in 93 % to 97 % of cases', () => {
    expect(held).toBeGreaterThanOrEqual(0.93);
    expect(held).toBeLessThanOrEqual(0.97);
  });
});
