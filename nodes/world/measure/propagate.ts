/** Distances, heights and angles of noisy points, with first-order propagation of their errors (ISO/IEC Guide 98-3, section 5.1). */

/** Half-width of the interval that contains 95 % of a normal distribution, in standard deviations. */
export const INTERVAL_95 = 1.96;

/** Smaller lengths (meters), areas (square meters) and sines of angles count as 0, where first-order derivatives do not exist. */
export const TINY = 1e-9;

/** The noise of a point that was found by a ray from the viewer. */
export interface PointNoise {
  /** Standard deviation along the ray at `referenceM`, meters. */
  readonly alongM: number;
  readonly referenceM: number;
  /** How the deviation along the ray grows with the distance: with its square, or not. */
  readonly growth: 'square' | 'none';
  /**
   * Standard deviation of the ray's direction, in each of two axes across it, radians. The deviation across the ray therefore grows with
   * the distance.
   */
  readonly acrossRad: number;
}

/**
 * A measured point in world space, with the covariance of its error: `alongM²` along the unit vector `ray`, `acrossM²` in each axis across
 * it.
 */
export interface SeenPoint {
  readonly positionM: Float64Array;
  readonly ray: Float64Array;
  alongM: number;
  acrossM: number;
}

/** A measured value, in meters or radians, and the standard deviation of its error in the same unit. */
export interface Measured {
  value: number;
  sigma: number;
}

/** Creates a point at the origin without noise. */
export function createSeenPoint(): SeenPoint {
  return { positionM: new Float64Array(3), ray: Float64Array.of(0, 0, -1), alongM: 0, acrossM: 0 };
}

/**
 * Sets the ray and the deviations of a point that is seen from a place.
 *
 * @param point Its `positionM` is read.
 * @param eyeM The place of the viewer: three numbers, world space, meters. If it is the point itself, there is no direction and no noise.
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

/** Measures the height of a point above the floor, which is its y coordinate. */
export function measureHeight(a: SeenPoint, out: Measured): void {
  gradient.fill(0);
  gradient[1] = 1;
  out.value = a.positionM[1] ?? 0;
  out.sigma = Math.sqrt(variance(a, gradient));
}

/** Measures the distance of two points. If they are equal, so that it has no derivative, `sigma` is that of the vector between them. */
export function measureDistance(a: SeenPoint, b: SeenPoint, out: Measured): void {
  out.value = setDirection(gradient, b.positionM, a.positionM);
  out.sigma = Math.sqrt(out.value > TINY ? variance(a, gradient) + variance(b, gradient) : totalVariance(a) + totalVariance(b));
}

/**
 * Measures the angle at `b` between the directions to `a` and `c`, in [0, π]. At 0 and π it has no derivative; `sigma` is then that of the
 * deviation in both axes across. `sigma` is at most π. If an arm has no length, the angle is undefined: its value is 0 and its `sigma` π.
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
 * The variance of an angle θ. With unit vectors u to `a` and w to `c`, its derivative by `a` is (u cos θ − w) / (|a − b| sin θ), that by
 * `c` the same with u and w exchanged, and that by `b` minus their sum.
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

/** The variance of an angle whose arms are in one line: for each point, the variance in all directions minus that along the line. */
function straightVariance(a: SeenPoint, b: SeenPoint, c: SeenPoint, lengthA: number, lengthC: number, cosine: number): number {
  const across = (point: SeenPoint) => totalVariance(point) - variance(point, towardsA);
  // The vertex bends both arms: by the sum of both rates where they point away from each other, else by the difference.
  const atVertex = 1 / lengthA - Math.sign(cosine) / lengthC;
  return across(a) / lengthA ** 2 + across(c) / lengthC ** 2 + across(b) * atVertex ** 2;
}

/** The variance of a quantity that has this derivative by the point. */
export function variance(point: SeenPoint, derivative: Float64Array): number {
  const along = dot(point.ray, derivative);
  const across = Math.max(0, dot(derivative, derivative) - along * along);
  return (point.alongM * along) ** 2 + point.acrossM ** 2 * across;
}

function totalVariance(point: SeenPoint): number {
  return point.alongM ** 2 + 2 * point.acrossM ** 2;
}

/** Writes the unit vector from one point to another, or zeros if they are equal, and returns their distance. */
export function setDirection(out: Float64Array, from: Float64Array, to: Float64Array): number {
  for (let i = 0; i < 3; i++) out[i] = (to[i] ?? 0) - (from[i] ?? 0);
  const size = length(out);
  for (let i = 0; i < 3; i++) out[i] = size > TINY ? (out[i] ?? 0) / size : 0;
  return size;
}

/** Component `i` of the vector product of `towardsA` and `towardsC`. */
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
