import { linearFromSrgb } from '../color-math.ts';
import { type Direction, sphereSamples } from './capture-targets.ts';
import { type PanoramaShot, projectDirection, type ShotPoint } from './shot.ts';

/** Factors on the linear red, green and blue of a photo. */
export type Gain = readonly [red: number, green: number, blue: number];

export const NO_GAIN: Gain = [1, 1, 1];

/** The number of directions at which photos are compared; they are about 2° apart. */
const SAMPLES = 8192;
/** Only bytes between these two are compared: darker ones are lost in noise, brighter ones are clipped. */
const DARKEST = 12;
const BRIGHTEST = 245;
/**
 * Weight of the wish that a photo does not change, in samples. It keeps the mean brightness of all photos, and leaves photos without
 * overlap unchanged.
 */
const PRIOR = 2;

/**
 * Computes factors that give overlapping photos the same brightness and white balance: least squares of the logarithms over all pairs
 * (after Brown and Lowe 2007, “Automatic Panoramic Image Stitching”, §6, whose gains have a bias to dark photos).
 */
export function evenGains(shots: readonly PanoramaShot[]): Gain[] {
  const count = shots.length;
  /** For each pair of photos, the number of compared samples, and the sums of the logarithm of the first over the second, per channel. */
  const pairs = new Map<number, [samples: number, red: number, green: number, blue: number]>();
  const colors = shots.map(() => [0, 0, 0] as [number, number, number]);
  const shown: number[] = [];
  for (const direction of sphereSamples(SAMPLES)) {
    shown.length = 0;
    for (const [i, shot] of shots.entries()) if (readLogarithms(colors[i] as [number, number, number], shot, direction)) shown.push(i);
    for (const first of shown) {
      for (const second of shown) {
        if (second <= first) continue;
        const pair = pairs.get(first * count + second) ?? [0, 0, 0, 0];
        pair[0]++;
        for (let c = 0; c < 3; c++) pair[c + 1] = (pair[c + 1] ?? 0) + (colors[first]?.[c] ?? 0) - (colors[second]?.[c] ?? 0);
        pairs.set(first * count + second, pair);
      }
    }
  }
  const channels = [1, 2, 3].map((channel) => solveChannel(pairs, count, channel));
  return shots.map((_, i) => [gainAt(channels[0], i), gainAt(channels[1], i), gainAt(channels[2], i)]);
}

function gainAt(logarithms: Float64Array | undefined, i: number): number {
  return Math.exp(logarithms?.[i] ?? 0);
}

/** Minimizes Σ n (l_first + mean − l_second)² + prior Σ l². */
function solveChannel(pairs: ReadonlyMap<number, readonly number[]>, count: number, channel: number): Float64Array {
  const matrix = Array.from({ length: count }, (_, i) => Float64Array.from({ length: count + 1 }, (__, k) => (k === i ? PRIOR : 0)));
  for (const [key, pair] of pairs) {
    const [first, second] = [Math.floor(key / count), key % count];
    const [samples = 0] = pair;
    const sum = pair[channel] ?? 0;
    const [upper, lower] = [matrix[first], matrix[second]];
    if (!upper || !lower) continue;
    upper[first] = (upper[first] ?? 0) + samples;
    lower[second] = (lower[second] ?? 0) + samples;
    upper[second] = (upper[second] ?? 0) - samples;
    lower[first] = (lower[first] ?? 0) - samples;
    upper[count] = (upper[count] ?? 0) - sum;
    lower[count] = (lower[count] ?? 0) + sum;
  }
  return solve(matrix, count);
}

/** Gaussian elimination. The matrix is symmetric and positive definite, so that it needs no pivots. */
function solve(matrix: readonly Float64Array[], count: number): Float64Array {
  for (const [i, row] of matrix.entries()) {
    const pivot = row[i] ?? 1;
    for (const other of matrix.slice(i + 1)) {
      const factor = (other[i] ?? 0) / pivot;
      if (factor === 0) continue;
      for (let k = i; k <= count; k++) other[k] = (other[k] ?? 0) - factor * (row[k] ?? 0);
    }
  }
  const result = new Float64Array(count);
  for (let i = count - 1; i >= 0; i--) {
    const row = matrix[i];
    let sum = row?.[count] ?? 0;
    for (let k = i + 1; k < count; k++) sum -= (row?.[k] ?? 0) * (result[k] ?? 0);
    result[i] = sum / (row?.[i] ?? 1);
  }
  return result;
}

const scratchPoint: ShotPoint = { x: 0, y: 0 };

/**
 * Writes the logarithms of a photo's linear color in a direction. Returns false if the photo does not show the direction, or is too dark or
 * too bright there.
 */
function readLogarithms(out: [number, number, number], shot: PanoramaShot, [x, y, z]: Direction): boolean {
  if (!projectDirection(scratchPoint, shot, x, y, z)) return false;
  const column = Math.min(Math.floor(((scratchPoint.x + 1) / 2) * shot.widthPx), shot.widthPx - 1);
  const row = Math.min(Math.floor(((scratchPoint.y + 1) / 2) * shot.heightPx), shot.heightPx - 1);
  const at = (row * shot.widthPx + column) * 4;
  for (let c = 0; c < 3; c++) {
    const byte = shot.data[at + c] ?? 0;
    if (byte < DARKEST || byte > BRIGHTEST) return false;
    out[c] = Math.log(linearFromSrgb(byte / 255));
  }
  return true;
}
