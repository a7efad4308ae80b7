/**
 * Fits a plane to the surface around a sample of a depth image. For a plane n·p = 1 in view space, seen along (X, Y, -1), 1 / depth is nx X
 * + ny Y - nz. This is linear, so noisy samples are averaged by least squares.
 *
 * A window that spans an edge contains two surfaces. Nine planes are fitted: to the whole inner window and to eight halves of it, of which
 * at least one lies on one side of a straight edge. The plane with the least median residual wins (least median of squares, Rousseeuw
 * 1984), because more than half of the window belongs to the surface at its center. Then a plane is fitted to those samples of a wider
 * window that agree with it.
 */

/** Half the sides of the inner and the wider window, samples. */
const INNER = 3;
const WIDE = 6;
/** Samples that differ from the depth of the hit by more than this fraction of it belong to another surface. */
const GAP = 0.1;
/** Maximum residual of a sample that agrees with a plane, in standard deviations. */
const AGREES = 2.5;
/** Standard deviation of a normal distribution, relative to the median of its absolute values. */
const SIGMA_OF_MEDIAN = 1.4826;
/** Minimum standard deviation, as a fraction of the depth: less than the resolution of depth in 16 bits or millimeters. */
const LEAST_SIGMA = 1e-5;

/**
 * The plane a X + b Y + c = 1 / depth, whose normal is (a, b, -c) in view space, and the standard deviation of its samples, as a fraction
 * of their depth.
 */
export interface FittedSurface {
  a: number;
  b: number;
  c: number;
  sigma: number;
}

/** A grid of depth samples, row by row. */
export interface SampleGrid {
  readonly meters: Float32Array;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** Sets `x` and `y` of the direction (x, y, -1) in view space that is seen at a UV of the texture. */
export type ToTangent = (u: number, v: number, out: { x: number; y: number }) => void;

const SIDE = 2 * WIDE + 1;
// Filled and read within one call: of the window, row by row; a value of 0 is unknown.
const tangentX = new Float64Array(SIDE * SIDE);
const tangentY = new Float64Array(SIDE * SIDE);
const values = new Float64Array(SIDE * SIDE);
const residuals = new Float64Array((2 * INNER + 1) ** 2);
/** Sums over the samples for the normal equations: of xx, xy, x, yy, y, 1, and of x, y and 1 times the value. */
const sums = new Float64Array(9);
const scratchTangent = { x: 0, y: 0 };
const candidate: FittedSurface = { a: 0, b: 0, c: 0, sigma: 0 };

/** Directions towards the eight halves of a window. */
const HALVES = Array.from({ length: 8 }, (_, i) => [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)] as const);

/**
 * Fits a plane to the surface around a sample.
 *
 * @param column, row The sample at the center.
 * @param depthM Depth at which the ray met the surface, meters.
 * @returns False if too few samples are known.
 */
export function fitSurface(
  out: FittedSurface,
  grid: SampleGrid,
  column: number,
  row: number,
  depthM: number,
  toTangent: ToTangent,
): boolean {
  readWindow(grid, column, row, depthM, toTangent);
  let least = Number.POSITIVE_INFINITY;
  for (let half = -1; half < HALVES.length; half++) {
    if (!leastSquares(candidate, INNER, half, Number.POSITIVE_INFINITY)) continue;
    const median = medianResidual(candidate);
    if (median >= least) continue;
    least = median;
    Object.assign(out, candidate);
  }
  if (least === Number.POSITIVE_INFINITY) return false;
  out.sigma = Math.max(LEAST_SIGMA, SIGMA_OF_MEDIAN * least);
  // Twice: the second time without the error of the small window.
  for (let pass = 0; pass < 2; pass++) {
    Object.assign(candidate, out);
    if (leastSquares(candidate, WIDE, -1, AGREES * out.sigma, out)) Object.assign(out, candidate);
  }
  return true;
}

function readWindow({ meters, widthPx, heightPx }: SampleGrid, column: number, row: number, depthM: number, toTangent: ToTangent): void {
  for (let dy = -WIDE; dy <= WIDE; dy++) {
    for (let dx = -WIDE; dx <= WIDE; dx++) {
      const i = (dy + WIDE) * SIDE + dx + WIDE;
      const x = column + dx;
      const y = row + dy;
      const isInside = x >= 0 && y >= 0 && x < widthPx && y < heightPx;
      const depth = isInside ? (meters[y * widthPx + x] ?? 0) : 0;
      values[i] = depth > 0 && Math.abs(depth - depthM) <= GAP * depthM ? 1 / depth : 0;
      if (values[i] === 0) continue;
      toTangent((x + 0.5) / widthPx, (y + 0.5) / heightPx, scratchTangent);
      tangentX[i] = scratchTangent.x;
      tangentY[i] = scratchTangent.y;
    }
  }
}

/** The residual of a sample from a plane, as a fraction of its depth. */
function residualAt(i: number, { a, b, c }: FittedSurface): number {
  const value = values[i] ?? 0;
  return Math.abs(a * (tangentX[i] ?? 0) + b * (tangentY[i] ?? 0) + c - value) / value;
}

function medianResidual(plane: FittedSurface): number {
  let count = 0;
  residuals.fill(Number.POSITIVE_INFINITY);
  for (let dy = -INNER; dy <= INNER; dy++) {
    for (let dx = -INNER; dx <= INNER; dx++) {
      const i = (dy + WIDE) * SIDE + dx + WIDE;
      if (values[i] !== 0) residuals[count++] = residualAt(i, plane);
    }
  }
  residuals.sort();
  return residuals[Math.floor(count / 2)] ?? Number.POSITIVE_INFINITY;
}

/**
 * Fits a plane by least squares to a window of half the side `reach`. A `half` other than -1 restricts the samples to that half; `near`
 * restricts them to those whose residual from this plane is at most `within`.
 */
function leastSquares(out: FittedSurface, reach: number, half: number, within: number, near?: FittedSurface): boolean {
  const direction = HALVES[half];
  sums.fill(0);
  for (let dy = -reach; dy <= reach; dy++) {
    for (let dx = -reach; dx <= reach; dx++) {
      const i = (dy + WIDE) * SIDE + dx + WIDE;
      const value = values[i] ?? 0;
      if (value === 0 || (direction && dx * direction[0] + dy * direction[1] < -0.5)) continue;
      if (near && residualAt(i, near) > within) continue;
      add(tangentX[i] ?? 0, tangentY[i] ?? 0, value);
    }
  }
  return solve(out);
}

function add(x: number, y: number, value: number): void {
  sums[0] = (sums[0] ?? 0) + x * x;
  sums[1] = (sums[1] ?? 0) + x * y;
  sums[2] = (sums[2] ?? 0) + x;
  sums[3] = (sums[3] ?? 0) + y * y;
  sums[4] = (sums[4] ?? 0) + y;
  sums[5] = (sums[5] ?? 0) + 1;
  sums[6] = (sums[6] ?? 0) + x * value;
  sums[7] = (sums[7] ?? 0) + y * value;
  sums[8] = (sums[8] ?? 0) + value;
}

/** Solves the normal equations about the mean of the samples by Cramer's rule. Returns false if the samples do not determine a plane. */
function solve(out: FittedSurface): boolean {
  const n = sums[5] ?? 0;
  if (n < 3) return false;
  const x = (sums[2] ?? 0) / n;
  const y = (sums[4] ?? 0) / n;
  const v = (sums[8] ?? 0) / n;
  const xx = (sums[0] ?? 0) / n - x * x;
  const xy = (sums[1] ?? 0) / n - x * y;
  const yy = (sums[3] ?? 0) / n - y * y;
  const xv = (sums[6] ?? 0) / n - x * v;
  const yv = (sums[7] ?? 0) / n - y * v;
  const determinant = xx * yy - xy * xy;
  if (!(Math.abs(determinant) > 1e-18)) return false;
  out.a = (xv * yy - yv * xy) / determinant;
  out.b = (yv * xx - xv * xy) / determinant;
  out.c = v - out.a * x - out.b * y;
  return Math.hypot(out.a, out.b, out.c) > 0;
}
