/**
 * Estimates the field of view of a camera whose lens is not known. The distance by which the image moves during a known rotation gives the
 * focal length.
 *
 * For two images and the rotation between them (`deviceorientation`), a Gauss–Newton search finds the focal length at which the first
 * image, warped by the rotation, equals the second. The pairs give different results, because sensors round to 0.1° and things move, so the
 * estimate is their weighted median.
 *
 * A device that its owner turns at arm's length also moves sideways. This looks like a longer focal length, with which objects on the floor
 * stay in place.
 */
export interface FovEstimator {
  /** Tangent of half the field of view of the longer side; null until it is known to about 3 %. */
  readonly tanHalfLongSide: number | null;
  /** Whether the estimate is final: further images do not change it. */
  readonly isDone: boolean;
  /**
   * Adds an image, if the camera has turned far enough since the last one that was kept.
   *
   * @param luminance Luminance of a small image, rows from the top. The array may be kept until a later call.
   * @param worldFromCamera Column-major 4×4, at the time of the image: x right, y up, -z ahead.
   * @returns Whether the array is kept; the caller must then pass another one next time.
   */
  add(luminance: Float32Array, widthPx: number, heightPx: number, worldFromCamera: ArrayLike<number>): boolean;
}

/** Limits of the rotation between the two images of a pair, radians: far above the rounding of sensors, and small enough for the search. */
const LEAST_RAD = 0.04;
const MOST_RAD = 0.12;
const MAX_PAIRS = 200;
const ENOUGH_PAIRS = 15;
const STEPS = 6;
/** Width of the border whose pixels are not compared, as a fraction of the side. */
const BORDER = 0.12;
/** Limits of the focal length, relative to the longer side of the image: fields of view of 112° to 27°. */
const SHORTEST = 0.34;
const LONGEST = 2.1;
/** Minimum correlation of a pair. If images agree less, something in them has moved. */
const LEAST_AGREEMENT = 0.5;

/**
 * Creates the estimation.
 *
 * @param tanHalfLongSide Initial value of the search.
 */
export function createFovEstimator(tanHalfLongSide: number): FovEstimator {
  /** The estimated focal length, relative to the longer side of the image. */
  let focal = 1 / (2 * tanHalfLongSide);
  let known = false;
  let before: Float32Array | null = null;
  const worldFromBefore = new Float64Array(9);
  const beforeFromNow = new Float64Array(9);
  const found: { focal: number; weight: number }[] = [];
  const pair = { focal: 0, weight: 0 };

  function keep(luminance: Float32Array, worldFromCamera: ArrayLike<number>): true {
    normalize(luminance);
    before = luminance;
    for (let i = 0; i < 9; i++) worldFromBefore[i] = worldFromCamera[i + Math.floor(i / 3)] ?? 0;
    return true;
  }
  function learn(): void {
    found.push({ ...pair });
    found.sort((a, b) => a.focal - b.focal);
    const total = found.reduce((sum, { weight }) => sum + weight, 0);
    focal = weightedQuantile(found, total / 2);
    const spread = (weightedQuantile(found, 0.75 * total) - weightedQuantile(found, 0.25 * total)) / focal;
    // Of a normal distribution the middle half is 1.35 σ wide, and the median of n is known to 1.25 σ / √n.
    known ||= found.length >= ENOUGH_PAIRS && (1.25 * spread) / 1.35 / Math.sqrt(found.length) < 0.015;
  }

  return {
    get tanHalfLongSide() {
      return known ? 1 / (2 * focal) : null;
    },
    get isDone() {
      return found.length >= MAX_PAIRS;
    },
    add: (luminance, widthPx, heightPx, worldFromCamera) => {
      if (before?.length !== luminance.length) return keep(luminance, worldFromCamera);
      const turnedRad = setRelative(beforeFromNow, worldFromBefore, worldFromCamera);
      if (turnedRad < LEAST_RAD) return false;
      const first = before;
      keep(luminance, worldFromCamera);
      if (turnedRad <= MOST_RAD && found.length < MAX_PAIRS) {
        pair.focal = focal;
        if (search(pair, first, luminance, widthPx, heightPx, beforeFromNow)) learn();
      }
      return true;
    },
  };
}

/** Scales luminance to mean 0 and standard deviation 1, so that exposure does not matter. */
function normalize(luminance: Float32Array): void {
  let sum = 0;
  for (let i = 0; i < luminance.length; i++) sum += luminance[i] ?? 0;
  const mean = sum / luminance.length;
  let squares = 0;
  for (let i = 0; i < luminance.length; i++) squares += ((luminance[i] ?? 0) - mean) ** 2;
  const scale = 1 / Math.sqrt(squares / luminance.length + 1e-9);
  for (let i = 0; i < luminance.length; i++) luminance[i] = ((luminance[i] ?? 0) - mean) * scale;
}

/** Writes the rotation from the axes of the camera now to those at the previous image, column-major 3×3. Returns its angle. */
function setRelative(out: Float64Array, worldFromBefore: Float64Array, worldFromNow: ArrayLike<number>): number {
  for (let column = 0; column < 3; column++) {
    for (let row = 0; row < 3; row++) {
      let sum = 0;
      for (let k = 0; k < 3; k++) sum += (worldFromBefore[3 * row + k] ?? 0) * (worldFromNow[4 * column + k] ?? 0);
      out[3 * column + row] = sum;
    }
  }
  const trace = (out[0] ?? 0) + (out[4] ?? 0) + (out[8] ?? 0);
  return Math.acos(Math.min(1, Math.max(-1, (trace - 1) / 2)));
}

// Filled and read within one call.
const scratchAt = { x: 0, y: 0 };
const scratchBeside = { x: 0, y: 0 };

/**
 * Refines `out.focal` by a pair of images and sets `out.weight`. Returns false if the images do not agree or do not determine the focal
 * length.
 */
function search(
  out: { focal: number; weight: number },
  first: Float32Array,
  second: Float32Array,
  widthPx: number,
  heightPx: number,
  firstFromSecond: Float64Array,
): boolean {
  const long = Math.max(widthPx, heightPx);
  const left = Math.ceil(BORDER * widthPx);
  const top = Math.ceil(BORDER * heightPx);
  for (let step = 0; step < STEPS; step++) {
    const focalPx = out.focal * long;
    const nudgePx = 0.002 * focalPx;
    let slopes = 0;
    let products = 0;
    let squares = 0;
    let agreement = 0;
    let size = 0;
    let count = 0;
    for (let y = top; y < heightPx - top; y++) {
      for (let x = left; x < widthPx - left; x++) {
        warp(scratchAt, x, y, widthPx, heightPx, focalPx, firstFromSecond);
        const { x: atX, y: atY } = scratchAt;
        if (atX < 1 || atY < 1 || atX > widthPx - 2 || atY > heightPx - 2) continue;
        warp(scratchBeside, x, y, widthPx, heightPx, focalPx + nudgePx, firstFromSecond);
        const value = sample(first, widthPx, atX, atY);
        const slopeX = (sample(first, widthPx, atX + 0.5, atY) - sample(first, widthPx, atX - 0.5, atY)) * (scratchBeside.x - atX);
        const slopeY = (sample(first, widthPx, atX, atY + 0.5) - sample(first, widthPx, atX, atY - 0.5)) * (scratchBeside.y - atY);
        const slope = (slopeX + slopeY) / nudgePx;
        const truth = second[y * widthPx + x] ?? 0;
        const error = truth - value;
        slopes += slope * slope;
        products += slope * error;
        squares += error * error;
        agreement += truth * value;
        size += (truth * truth + value * value) / 2;
        count++;
      }
    }
    if (count === 0 || !(slopes > 1e-9)) return false;
    out.focal += products / slopes / long;
    if (!(out.focal > SHORTEST && out.focal < LONGEST)) return false;
    out.weight = slopes / (squares / count + 1e-3);
    if (step === STEPS - 1) return agreement >= LEAST_AGREEMENT * size;
  }
  return false;
}

/** Writes where a pixel of the second image is in the first, in pixels; the centers of pixels have integer coordinates. */
function warp(
  out: { x: number; y: number },
  x: number,
  y: number,
  widthPx: number,
  heightPx: number,
  focalPx: number,
  m: Float64Array,
): void {
  const dx = (x - (widthPx - 1) / 2) / focalPx;
  const dy = -(y - (heightPx - 1) / 2) / focalPx;
  const z = (m[2] ?? 0) * dx + (m[5] ?? 0) * dy - (m[8] ?? 0);
  out.x = (widthPx - 1) / 2 - (focalPx * ((m[0] ?? 0) * dx + (m[3] ?? 0) * dy - (m[6] ?? 0))) / z;
  out.y = (heightPx - 1) / 2 + (focalPx * ((m[1] ?? 0) * dx + (m[4] ?? 0) * dy - (m[7] ?? 0))) / z;
}

function sample(image: Float32Array, widthPx: number, x: number, y: number): number {
  const column = Math.floor(x);
  const row = Math.floor(y);
  const at = row * widthPx + column;
  const s = x - column;
  const t = y - row;
  const above = (image[at] ?? 0) * (1 - s) + (image[at + 1] ?? 0) * s;
  const below = (image[at + widthPx] ?? 0) * (1 - s) + (image[at + widthPx + 1] ?? 0) * s;
  return above * (1 - t) + below * t;
}

function weightedQuantile(sorted: readonly { readonly focal: number; readonly weight: number }[], until: number): number {
  let sum = 0;
  for (const { focal, weight } of sorted) {
    sum += weight;
    if (sum >= until) return focal;
  }
  return sorted.at(-1)?.focal ?? 1;
}
