/**
 * Lengths of polylines, areas and volumes of noisy points, with first-order propagation of their errors (ISO/IEC Guide 98-3,
 * section 5.1). Each point's gradient is multiplied with its covariance (`variance`).
 */

import { createSeenPoint, type Measured, type SeenPoint, setDirection, TINY, variance } from './propagate.ts';

// Filled and read within one call.
const before = new Float64Array(3);
const after = new Float64Array(3);
const gradient = new Float64Array(3);
const normal = new Float64Array(3);
const u = new Float64Array(3);
const v = new Float64Array(3);
const w = new Float64Array(3);
const product = new Float64Array(3);
const NOWHERE = createSeenPoint();

/** Measures the length of the line through the first `count` points. A segment without length has no direction and adds no error. */
export function measurePolyline(points: readonly SeenPoint[], count: number, out: Measured): void {
  let length = 0;
  let squared = 0;
  before.fill(0);
  for (let i = 0; i < count; i++) {
    const point = points[i] ?? NOWHERE;
    const next = i + 1 < count ? points[i + 1] : undefined;
    const segmentM = next ? setDirection(after, point.positionM, next.positionM) : 0;
    if (segmentM <= TINY) after.fill(0);
    length += segmentM;
    for (let k = 0; k < 3; k++) gradient[k] = (before[k] ?? 0) - (after[k] ?? 0);
    squared += variance(point, gradient);
    before.set(after);
  }
  out.value = length;
  out.sigma = Math.sqrt(squared);
}

/**
 * Measures the area of the rectangle that has the side from `a` to `b`, and whose opposite side goes through `c`: |(b − a) × (c − b)|. If
 * the area is 0 and has no derivative, `sigma` is the length of the side times the deviation of `c`.
 */
export function measureRectangle(a: SeenPoint, b: SeenPoint, c: SeenPoint, out: Measured): void {
  subtract(u, b, a);
  subtract(w, c, b);
  cross(product, u, w);
  out.value = unit(normal, product);
  if (out.value <= TINY) {
    out.sigma = Math.hypot(u[0] ?? 0, u[1] ?? 0, u[2] ?? 0) * Math.hypot(c.alongM, c.acrossM);
    return;
  }
  cross(before, w, normal);
  cross(after, normal, u);
  for (let k = 0; k < 3; k++) gradient[k] = -(before[k] ?? 0);
  let squared = variance(a, gradient) + variance(c, after);
  for (let k = 0; k < 3; k++) gradient[k] = (before[k] ?? 0) - (after[k] ?? 0);
  squared += variance(b, gradient);
  out.sigma = Math.sqrt(squared);
}

/**
 * Measures the area of the polygon of the first `count` points, projected along its mean normal (Newell): ½ |Σ pᵢ × pᵢ₊₁|. Edges must not
 * cross, because the parts on their two sides would count with opposite signs. The derivative by pᵢ is ½ (pᵢ₊₁ − pᵢ₋₁) × n.
 */
export function measurePolygon(points: readonly SeenPoint[], count: number, out: Measured): void {
  const origin = points[0] ?? NOWHERE;
  normal.fill(0);
  for (let i = 1; i + 1 < count; i++) {
    subtract(u, points[i] ?? NOWHERE, origin);
    subtract(v, points[i + 1] ?? NOWHERE, origin);
    cross(product, u, v);
    for (let k = 0; k < 3; k++) normal[k] = (normal[k] ?? 0) + (product[k] ?? 0) / 2;
  }
  out.value = unit(normal, normal);
  let squared = 0;
  for (let i = 0; i < count; i++) {
    subtract(u, points[(i + 1) % count] ?? NOWHERE, points[(i + count - 1) % count] ?? NOWHERE);
    cross(gradient, u, normal);
    for (let k = 0; k < 3; k++) gradient[k] = (gradient[k] ?? 0) / 2;
    squared += variance(points[i] ?? NOWHERE, gradient);
  }
  out.sigma = Math.sqrt(squared);
}

/**
 * Measures the volume of the box whose base is the rectangle of `a`, `b` and `c` (`measureRectangle`), and whose opposite face goes through
 * `d`: |((b − a) × (c − b)) · (d − a)|.
 */
export function measureBox(a: SeenPoint, b: SeenPoint, c: SeenPoint, d: SeenPoint, out: Measured): void {
  subtract(u, b, a);
  subtract(w, c, b);
  subtract(v, d, a);
  cross(product, u, w);
  const signed = (product[0] ?? 0) * (v[0] ?? 0) + (product[1] ?? 0) * (v[1] ?? 0) + (product[2] ?? 0) * (v[2] ?? 0);
  const side = signed < 0 ? -1 : 1;
  cross(before, w, v);
  cross(after, v, u);
  for (let k = 0; k < 3; k++) gradient[k] = side * (product[k] ?? 0);
  let squared = variance(d, gradient);
  for (let k = 0; k < 3; k++) gradient[k] = -side * ((before[k] ?? 0) + (product[k] ?? 0));
  squared += variance(a, gradient);
  for (let k = 0; k < 3; k++) gradient[k] = side * ((before[k] ?? 0) - (after[k] ?? 0));
  squared += variance(b, gradient);
  for (let k = 0; k < 3; k++) gradient[k] = side * (after[k] ?? 0);
  squared += variance(c, gradient);
  out.value = Math.abs(signed);
  out.sigma = Math.sqrt(squared);
}

function subtract(out: Float64Array, to: SeenPoint, from: SeenPoint): void {
  for (let k = 0; k < 3; k++) out[k] = (to.positionM[k] ?? 0) - (from.positionM[k] ?? 0);
}

function cross(out: Float64Array, a: Float64Array, b: Float64Array): void {
  for (let k = 0; k < 3; k++) {
    const i = (k + 1) % 3;
    const j = (k + 2) % 3;
    out[k] = (a[i] ?? 0) * (b[j] ?? 0) - (a[j] ?? 0) * (b[i] ?? 0);
  }
}

/** Writes the unit vector along a vector, or zeros if it has no length, and returns its length. */
function unit(out: Float64Array, of: Float64Array): number {
  const size = Math.hypot(of[0] ?? 0, of[1] ?? 0, of[2] ?? 0);
  for (let k = 0; k < 3; k++) out[k] = size > TINY ? (of[k] ?? 0) / size : 0;
  return size;
}
