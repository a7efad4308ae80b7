import { expect, test } from '@jest/globals';
import { createRandom } from '../../export/runtime/random.ts';
import { type Box, type Curve, type Distance, distanceToCurve, isNearer } from './curve-distance.ts';

const TOLERANCE = 0.5;
const FAR: Distance = { toBox: 1e9, toCenter: 1e9 };

test('the distance is that to the nearest of many points of the curve', () => {
  const { next } = createRandom(7, 'curves');
  const inRange = () => 1000 * next();
  for (let i = 0; i < 60; i++) {
    const curve = Array.from({ length: 8 }, inRange) as readonly number[] as Curve;
    const size = i % 3 === 0 ? 0 : 150;
    const box = { x: inRange(), y: inRange(), width: size, height: size / 2 };
    const found = distanceToCurve(curve, box, FAR, TOLERANCE);
    const sampled = nearestSample(curve, box);
    expect(Math.abs(found.toBox - sampled.toBox)).toBeLessThan(2);
    // Of a curve that runs along the box, any point is the nearest.
    if (sampled.toBox === 0) expect(Math.abs(found.toCenter - sampled.toCenter)).toBeLessThan(2);
  }
});

test('a curve that is not nearer than the limit gives the limit itself', () => {
  const line: Curve = [0, 0, 30, 0, 60, 0, 90, 0];
  const point = { x: 45, y: 10, width: 0, height: 0 };
  const limit = { toBox: 9, toCenter: Number.POSITIVE_INFINITY };
  expect(distanceToCurve(line, point, limit, TOLERANCE)).toBe(limit);
  expect(distanceToCurve(line, { ...point, y: 8 }, limit, TOLERANCE).toBox).toBeCloseTo(8, 5);
});

test('of two curves that cross a box, the one nearer to its center is nearer', () => {
  const box = { x: 0, y: 0, width: 100, height: 40 };
  const at = (y: number) => distanceToCurve([-50, y, 0, y, 100, y, 150, y], box, FAR, TOLERANCE);
  expect([at(5).toBox, at(25).toBox]).toEqual([0, 0]);
  expect(isNearer(at(25), at(5))).toBe(true);
  expect(isNearer(at(5), at(25))).toBe(false);
});

function nearestSample([x0, y0, x1, y1, x2, y2, x3, y3]: Curve, { x, y, width, height }: Box): Distance {
  let least = FAR;
  for (let i = 0; i <= 1500; i++) {
    const t = i / 1500;
    const of = (a: number, b: number, c: number, d: number) =>
      a * (1 - t) ** 3 + 3 * b * t * (1 - t) ** 2 + 3 * c * t * t * (1 - t) + d * t ** 3;
    const [px, py] = [of(x0, x1, x2, x3), of(y0, y1, y2, y3)];
    const sample = {
      toBox: Math.hypot(Math.max(x - px, px - x - width, 0), Math.max(y - py, py - y - height, 0)),
      toCenter: Math.hypot(px - x - width / 2, py - y - height / 2),
    };
    if (isNearer(sample, least)) least = sample;
  }
  return least;
}
