import { type Curve, curveAt, findSlopes, MAX_CURVE_POINTS, MIN_CURVE_POINTS } from '../../nodes/kit/curve.ts';

/** A point in the unit square of a curve, from (0, 0) at the bottom left to (1, 1). */
export interface CurvePoint {
  readonly x: number;
  readonly y: number;
}

/** Precision of coordinates, and least distance of two points in x. */
const STEP = 0.001;

export function pointsOf(curve: Curve): readonly CurvePoint[] {
  return Array.from({ length: curve.length / 2 }, (_, i) => ({ x: curve[2 * i] ?? 0, y: curve[2 * i + 1] ?? 0 }));
}

/** Adds a point on the curve at `x`. Returns the curve and the index of the point, or null if it is full or has a point there. */
export function withPoint(curve: Curve, x: number): { readonly curve: Curve; readonly index: number } | null {
  const points = pointsOf(curve);
  const at = round(x);
  if (points.length >= MAX_CURVE_POINTS || at < 0 || at > 1 || points.some((point) => Math.abs(point.x - at) < STEP)) return null;
  const index = points.filter((point) => point.x < at).length;
  return { curve: [...curve.slice(0, 2 * index), at, round(curveAt(curve, at)), ...curve.slice(2 * index)], index };
}

/** Adds a point in the middle of the widest gap, including those to the edges. */
export function withPointInGap(curve: Curve): { readonly curve: Curve; readonly index: number } | null {
  const borders = [0, ...pointsOf(curve).map(({ x }) => x), 1];
  const gaps = borders.slice(1).map((to, i) => ({ to, from: borders[i] ?? 0 }));
  const widest = gaps.reduce((a, b) => (b.to - b.from > a.to - a.from ? b : a));
  return withPoint(curve, (widest.from + widest.to) / 2);
}

export function canLosePoint(curve: Curve): boolean {
  return curve.length > 2 * MIN_CURVE_POINTS;
}

export function withoutPoint(curve: Curve, index: number): Curve {
  return canLosePoint(curve) ? curve.filter((_, i) => i >> 1 !== index) : curve;
}

/** Moves a point, clamped to its neighbors and the square. */
export function withPointAt(curve: Curve, index: number, { x, y }: CurvePoint): Curve {
  const least = index === 0 ? 0 : (curve[2 * index - 2] ?? 0) + STEP;
  const most = 2 * index + 2 < curve.length ? (curve[2 * index + 2] ?? 1) - STEP : 1;
  return curve.map((number, i) => (i >> 1 !== index ? number : i % 2 === 0 ? round(clamp(x, least, most)) : round(clamp(y, 0, 1))));
}

/** SVG path data in a unit square, y down. Each cubic of the curve becomes an equal Bézier curve. */
export function curvePath(curve: Curve): string {
  const slopes = new Float64Array(MAX_CURVE_POINTS);
  findSlopes(curve, slopes);
  const points = pointsOf(curve);
  const parts = points.map(({ x, y }, i) => {
    const before = points[i - 1];
    if (!before) return `M0 ${show(1 - y)}H${show(x)}`;
    const third = (x - before.x) / 3;
    const from = `${show(before.x + third)} ${show(1 - before.y - third * (slopes[i - 1] ?? 0))}`;
    return `C${from} ${show(x - third)} ${show(1 - y + third * (slopes[i] ?? 0))} ${show(x)} ${show(1 - y)}`;
  });
  return `${parts.join('')}H1`;
}

function show(number: number): string {
  return String(Number(number.toFixed(4)));
}

function round(number: number): number {
  return Math.round(number / STEP) / (1 / STEP);
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
