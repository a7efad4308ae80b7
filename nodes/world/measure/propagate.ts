/** Distances, heights and angles of noisy points, with first-order propagation of their errors (ISO/IEC Guide 98-3, section 5.1). */

/** Half-width of the interval that holds 95 % of a normal distribution, in standard deviations. */
export const INTERVAL_95 = 1.96;

/** Below this a length, in meters, an area, in square meters, or the sine of an angle counts as 0, where the first-order derivatives do not exist. */
export const TINY = 1e-9;

/** The noise of a point that a ray from the viewer found. */
export interface PointNoise {
  /** Standard deviation along the ray at `referenceM`, meters. */
  readonly alongM: number;
  readonly referenceM: number;
  /** How the deviation along the ray grows with the distance. */
  readonly growth: 'square' | 'none';
  /** Standard deviation of the direction, in each of two axes across the ray, radians: the deviation across grows with the distance. */
  readonly acrossRad: number;
}

/** A point in world space, with the covariance of its error: `alongM²` along the unit vector `ray`, `acrossM²` in each axis across. */
export interface SeenPoint {
  readonly positionM: Float64Array;
  readonly ray: Float64Array;
  alongM: number;
  acrossM: number;
}

/** A result, in meters or radians, and the standard deviation of its error in the same unit. */
export interface Measured {
  value: number;
  sigma: number;
}

/** @returns A point at the origin without noise. */
export function createSeenPoint(): SeenPoint {
  return { positionM: new Float64Array(3), ray: Float64Array.of(0, 0, -1), alongM: 0, acrossM: 0 };
}

/**
 * Sets the direction and the deviations of a point from where it is seen.
 *
 * @param point Its `positionM` is read.
 * @param eyeM Three numbers, world space, meters. At the point itself there is no direction and no noise.
 *
 * @example
 * point.positionM.set([0, 0, -0.4]);
 * setNoise(point, [0, 0, 0], { alongM: 0.0073, referenceM: 0.4, growth: 'square', acrossRad: 0 });
 * point.alongM; // 0.0073
 */
export function setNoise(point: SeenPoint, eyeM: ArrayLike<number>, noise: PointNoise): void {
  const { positionM, ray } = point;
  for (let i = 0; i < 3; i++) ray[i] = (positionM[i] ?? 0) - (eyeM[i] ?? 0);
  const distanceM = length(ray);
  const isAway = distanceM > TINY;
  for (let i = 0; i < 3; i++) ray[i] = isAway ? (ray[i] ?? 0) / distanceM : 0;
  const ratio = noise.growth === 'square' ? (distanceM / noise.referenceM) ** 2 : 1;
  point.alongM = isAway ? noise.alongM * ratio : 0;
  point.acrossM = noise.acrossRad * distanceM;
}

// Filled and read within one call.
const towardsA = new Float64Array(3);
const towardsC = new Float64Array(3);
const gradient = new Float64Array(3);

/** The y coordinate of a point: its height above the floor. */
export function measureHeight(a: SeenPoint, out: Measured): void {
  gradient.fill(0);
  gradient[1] = 1;
  out.value = a.positionM[1] ?? 0;
  out.sigma = Math.sqrt(variance(a, gradient));
}

/** The distance of two points. At the same point, where it has no derivative, `sigma` is that of the vector between them. */
export function measureDistance(a: SeenPoint, b: SeenPoint, out: Measured): void {
  out.value = setDirection(gradient, b.positionM, a.positionM);
  out.sigma = Math.sqrt(out.value > TINY ? variance(a, gradient) + variance(b, gradient) : totalVariance(a) + totalVariance(b));
}

/**
 * The angle at `b` between the directions to `a` and `c`, in [0, π]. At 0 and π, where it has no derivative, `sigma` is that of the
 * deviation in both axes across. `sigma` is at most π, also where an arm has no length and the angle is undefined: its value is 0.
 */
export function measureAngle(a: SeenPoint, b: SeenPoint, c: SeenPoint, out: Measured): void {
  const lengthA = setDirection(towardsA, b.positionM, a.positionM);
  const lengthC = setDirection(towardsC, b.positionM, c.positionM);
  if (lengthA <= TINY || lengthC <= TINY) {
    out.value = 0;
    out.sigma = Math.PI;
    return;
  }
  const cosine = dot(towardsA, towardsC);
  // By the length of the cross product, which is exact near 0 and π, where the arc cosine is not.
  const sine = Math.hypot(cross(0), cross(1), cross(2));
  out.value = Math.atan2(sine, cosine);
  const squared =
    sine > TINY ? angleVariance(a, b, c, lengthA, lengthC, cosine, sine) : straightVariance(a, b, c, lengthA, lengthC, cosine);
  out.sigma = Math.min(Math.PI, Math.sqrt(squared));
}

/**
 * With unit vectors u to `a` and w to `c`, the derivative by `a` is (u cos θ − w) / (|a − b| sin θ), that by `c` the same with u and w
 * exchanged, and that by `b` minus their sum.
 */
function angleVariance(a: SeenPoint, b: SeenPoint, c: SeenPoint, lengthA: number, lengthC: number, cosine: number, sine: number): number {
  const byA = (i: number) => ((towardsA[i] ?? 0) * cosine - (towardsC[i] ?? 0)) / (lengthA * sine);
  const byC = (i: number) => ((towardsC[i] ?? 0) * cosine - (towardsA[i] ?? 0)) / (lengthC * sine);
  for (let i = 0; i < 3; i++) gradient[i] = byA(i);
  let sum = variance(a, gradient);
  for (let i = 0; i < 3; i++) gradient[i] = byC(i);
  sum += variance(c, gradient);
  for (let i = 0; i < 3; i++) gradient[i] = -byA(i) - byC(i);
  return sum + variance(b, gradient);
}

/** Of arms in one line: the variance of all directions minus that along the line, for each point. */
function straightVariance(a: SeenPoint, b: SeenPoint, c: SeenPoint, lengthA: number, lengthC: number, cosine: number): number {
  const across = (point: SeenPoint) => totalVariance(point) - variance(point, towardsA);
  // The vertex bends both arms: by the sum of both rates where they point away from each other, else by the difference.
  const atVertex = 1 / lengthA - Math.sign(cosine) / lengthC;
  return across(a) / lengthA ** 2 + across(c) / lengthC ** 2 + across(b) * atVertex ** 2;
}

/** Variance of a quantity with that derivative by the point. */
export function variance(point: SeenPoint, derivative: Float64Array): number {
  const along = dot(point.ray, derivative);
  const across = Math.max(0, dot(derivative, derivative) - along * along);
  return (point.alongM * along) ** 2 + point.acrossM ** 2 * across;
}

function totalVariance(point: SeenPoint): number {
  return point.alongM ** 2 + 2 * point.acrossM ** 2;
}

/** Writes the unit vector between two points, zeros where they are the same, and returns their distance. */
export function setDirection(out: Float64Array, from: Float64Array, to: Float64Array): number {
  for (let i = 0; i < 3; i++) out[i] = (to[i] ?? 0) - (from[i] ?? 0);
  const size = length(out);
  for (let i = 0; i < 3; i++) out[i] = size > TINY ? (out[i] ?? 0) / size : 0;
  return size;
}

/** A component of `towardsA` × `towardsC`. */
function cross(i: number): number {
  const j = (i + 1) % 3;
  const k = (i + 2) % 3;
  return (towardsA[j] ?? 0) * (towardsC[k] ?? 0) - (towardsA[k] ?? 0) * (towardsC[j] ?? 0);
}

function dot(a: Float64Array, b: Float64Array): number {
  return (a[0] ?? 0) * (b[0] ?? 0) + (a[1] ?? 0) * (b[1] ?? 0) + (a[2] ?? 0) * (b[2] ?? 0);
}

function length(a: Float64Array): number {
  return Math.hypot(a[0] ?? 0, a[1] ?? 0, a[2] ?? 0);
}
