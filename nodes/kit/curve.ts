/**
 * A curve as the value of a param: the points `[x, y, x, y, …]` that it passes through, in [0, 1], sorted by x. Before the first point
 * and after the last it is constant.
 *
 * Between points it is a monotone cubic, which does not overshoot, so that images get no bands or clipped tones that the points do not
 * contain: F. N. Fritsch, R. E. Carlson 1980, Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17, 238, with the slopes
 * of F. N. Fritsch, J. Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300. SciPy's `PchipInterpolator` is the same.
 */
export type Curve = readonly number[];

/** The identity curve. */
export const DIAGONAL: Curve = [0, 0, 1, 1];

/** The fewest points of a curve. */
export const MIN_CURVE_POINTS = 2;

/** The most points of a curve. */
export const MAX_CURVE_POINTS = 8;

/** How many numbers a curve takes in the program's slots. A curve with fewer points repeats its last point. */
export const CURVE_NUMBERS = 2 * MAX_CURVE_POINTS;

/**
 * Checks whether a value is a curve.
 *
 * @param value Any value, such as one from a project file.
 * @returns Null for a curve; else what the value must be, in words for a diagnostic.
 *
 * @example
 * curveMisfit([0, 0, 1, 1]); // null
 */
export function curveMisfit(value: unknown): string | null {
  const isList = Array.isArray(value) && value.length % 2 === 0 && value.every(Number.isFinite);
  if (!isList || value.length < 2 * MIN_CURVE_POINTS || value.length > CURVE_NUMBERS)
    return `a curve of ${MIN_CURVE_POINTS} to ${MAX_CURVE_POINTS} points, [x, y, x, y, …]`;
  const numbers = value as Curve;
  if (numbers.some((number) => number < 0 || number > 1)) return 'a curve whose points lie from 0 to 1';
  for (let i = 2; i < numbers.length; i += 2)
    if ((numbers[i] ?? 0) <= (numbers[i - 2] ?? 0)) return 'a curve with each point further right than the one before';
  return null;
}

/**
 * Pads a curve to `CURVE_NUMBERS` numbers by repeating its last point.
 *
 * @returns A new array; `curve` is not changed.
 *
 * @example
 * paddedCurve(DIAGONAL).length; // CURVE_NUMBERS
 */
export function paddedCurve(curve: Curve): Curve {
  return paddedPoints(curve, 2, CURVE_NUMBERS);
}

/**
 * Pads a list of points to a length by repeating its last point.
 *
 * @param points Any list, such as a curve or a gradient.
 * @param pointNumbers How many numbers a point takes.
 * @returns A new array, which is longer than `length` if `points` is.
 *
 * @example
 * paddedPoints([1, 2, 3, 4], 2, 6); // [1, 2, 3, 4, 3, 4]
 */
export function paddedPoints(points: readonly number[], pointNumbers: number, length: number): readonly number[] {
  const padded = [...points];
  while (padded.length >= pointNumbers && padded.length < length) padded.push(...points.slice(-pointNumbers));
  return padded;
}

// Filled and read within one call.
const scratchSlopes = new Float64Array(MAX_CURVE_POINTS);

/**
 * Samples a curve at evenly spaced positions, the first at x = 0 and the last at x = 1.
 *
 * @param curve A curve, padded or not.
 * @param heights Receives one height per element, in [0, 1]; at least two elements.
 *
 * @example
 * sampleCurve(DIAGONAL, new Float32Array(3)); // [0, 0.5, 1]
 */
export function sampleCurve(curve: ArrayLike<number>, heights: Float32Array): void {
  const count = findSlopes(curve, scratchSlopes);
  const last = heights.length - 1;
  for (let i = 0; i <= last; i++) heights[i] = heightAt(curve, count, scratchSlopes, i / last);
}

/**
 * The height of a curve at one position.
 *
 * @param curve A curve, padded or not.
 * @param x In [0, 1]; outside its points the curve is constant.
 * @returns In [0, 1].
 *
 * @example
 * curveAt(DIAGONAL, 0.25); // 0.25
 */
export function curveAt(curve: ArrayLike<number>, x: number): number {
  return heightAt(curve, findSlopes(curve, scratchSlopes), scratchSlopes, x);
}

/**
 * Computes the slope of a curve at each of its points.
 *
 * @param curve A curve, padded or not.
 * @param slopes Receives one slope per point; at least `MAX_CURVE_POINTS` elements.
 * @returns The number of points, without padding.
 *
 * @example
 * findSlopes(DIAGONAL, slopes); // 2; slopes = [1, 1, …]
 */
export function findSlopes(curve: ArrayLike<number>, slopes: Float64Array): number {
  const last = countPoints(curve) - 1;
  for (let i = 0; i <= last; i++) {
    if (last < 2) slopes[i] = last < 1 ? 0 : steepness(curve, 0);
    else if (i === 0) slopes[i] = slopeAtEnd(width(curve, 0), width(curve, 1), steepness(curve, 0), steepness(curve, 1));
    else if (i === last) slopes[i] = slopeAtEnd(width(curve, i - 1), width(curve, i - 2), steepness(curve, i - 1), steepness(curve, i - 2));
    else slopes[i] = slopeBetween(width(curve, i - 1), width(curve, i), steepness(curve, i - 1), steepness(curve, i));
  }
  return last + 1;
}

/** The number of points without padding. Padding begins at the first point whose x does not increase. */
function countPoints(curve: ArrayLike<number>): number {
  let count = 1;
  while (2 * count < curve.length && width(curve, count - 1) > 0) count++;
  return count;
}

/** The distance along x from point `i` to the next. */
function width(curve: ArrayLike<number>, i: number): number {
  return (curve[2 * i + 2] ?? 0) - (curve[2 * i] ?? 0);
}

function steepness(curve: ArrayLike<number>, i: number): number {
  return ((curve[2 * i + 3] ?? 0) - (curve[2 * i + 1] ?? 0)) / width(curve, i);
}

/**
 * The slope at an inner point: the harmonic mean of the slopes on both sides, weighted by their widths; 0 at a peak, in a trough and beside
 * a level part.
 */
function slopeBetween(widthBefore: number, widthAfter: number, before: number, after: number): number {
  if (before * after <= 0) return 0;
  const a = 2 * widthAfter + widthBefore;
  const b = widthAfter + 2 * widthBefore;
  return (a + b) / (a / before + b / after);
}

/** The slope at an end point: that of the parabola through the three points at this end, limited so that the curve does not overshoot. */
function slopeAtEnd(widthHere: number, widthNext: number, here: number, next: number): number {
  const slope = ((2 * widthHere + widthNext) * here - widthHere * next) / (widthHere + widthNext);
  if (Math.sign(slope) !== Math.sign(here)) return 0;
  return Math.sign(here) !== Math.sign(next) && Math.abs(slope) > 3 * Math.abs(here) ? 3 * here : slope;
}

/** Evaluates the cubic Hermite spline between the two points around `x`. */
function heightAt(curve: ArrayLike<number>, count: number, slopes: Float64Array, x: number): number {
  let i = 0;
  while (i < count && (curve[2 * i] ?? 0) <= x) i++;
  if (i === 0 || i === count) return curve[2 * Math.max(i, 1) - 1] ?? 0;
  const from = curve[2 * i - 1] ?? 0;
  const to = curve[2 * i + 1] ?? 0;
  const across = width(curve, i - 1);
  const t = (x - (curve[2 * i - 2] ?? 0)) / across;
  const rest = 1 - t;
  return (
    rest * rest * (1 + 2 * t) * from + t * t * (3 - 2 * t) * to + across * t * rest * (rest * (slopes[i - 1] ?? 0) - t * (slopes[i] ?? 0))
  );
}
