import { linearFromSrgb, srgbFromLinear } from '../color-math.ts';
import { coverageOf } from './capture-targets.ts';
import { evenGains, NO_GAIN } from './even-exposure.ts';
import { fillHoles } from './fill-holes.ts';
import type { PanoramaPixels } from './pixels.ts';
import { cosineOfReach, edgeWeight, type PanoramaShot, projectDirection, type ShotPoint } from './shot.ts';

/** A panorama that was stitched from photos. */
export interface StitchedPanorama extends PanoramaPixels {
  readonly channels: 4;
  /** Display-referred sRGB, rows from the top. Alpha is 255 where a photo shows something, and 0 where a hole was filled. */
  readonly data: Uint8ClampedArray<ArrayBuffer>;
  /** The part of the sphere that no photo shows, by solid angle. */
  readonly holesPart: number;
  /** The part of the sphere that two photos or more show, by solid angle. */
  readonly overlapPart: number;
  /** Whether the exposure of the photos was adjusted to each other. */
  readonly evened: boolean;
}

/**
 * The exposure of photos is adjusted only if at least this part of the sphere is shown by two photos: with less overlap, exposure and
 * content cannot be told apart.
 */
export const LEAST_OVERLAP = 0.25;
/** Factor on the weight of a photo at points where it is clipped to white or black. */
const CLIPPED_WEIGHT = 0.02;
/** Bytes of sRGB from this value on count as clipped to white, as in `sphere-grid.ts`. */
const WHITE = 250;
const ROWS_PER_STEP = 16;

/**
 * Projects photos to an equirectangular panorama by their poses. Its center is the direction −z of world space. Yields now and then.
 *
 * Overlapping photos are averaged in linear light with weights that fade to their edges (Szeliski 2006, “Image Alignment and Stitching”,
 * §5.2), so that no seam is visible.
 *
 * @example
 * const panorama = runWhole(stitch(shots, 2048));
 */
export function* stitch(shots: readonly PanoramaShot[], widthPx: number): Generator<undefined, StitchedPanorama> {
  const heightPx = widthPx / 2;
  const { seenPart, overlapPart } = coverageOf(shots);
  const evened = overlapPart >= LEAST_OVERLAP && shots.length > 1;
  yield;
  const gains = evened ? evenGains(shots) : shots.map(() => NO_GAIN);
  const light = linearTable();
  const reach = shots.map((shot) => Math.max(cosineOfReach(shot), 0));
  /** Per pixel: red, green and blue times weight, and the sum of weights. */
  const sums = new Float32Array(widthPx * heightPx * 4);
  const [sines, cosines] = anglesOf(widthPx);
  const point: ShotPoint = { x: 0, y: 0 };
  for (let y = 0; y < heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    const elevationRad = Math.PI / 2 - ((y + 0.5) / heightPx) * Math.PI;
    const up = Math.sin(elevationRad);
    const level = Math.cos(elevationRad);
    for (const [i, shot] of shots.entries()) {
      const { worldFromView: m } = shot;
      const [backX, backY, backZ] = [m[8] ?? 0, m[9] ?? 0, m[10] ?? 0];
      const least = reach[i] ?? 0;
      // The row of the panorama is farther from the axis of the photo than its corners.
      if (up * -backY + level * Math.hypot(backX, backZ) < least) continue;
      const gain = gains[i] ?? NO_GAIN;
      for (let x = 0; x < widthPx; x++) {
        const [right, back] = [level * (sines[x] ?? 0), -level * (cosines[x] ?? 0)];
        if (-(backX * right + backY * up + backZ * back) < least) continue;
        if (projectDirection(point, shot, right, up, back)) addSample(sums, (y * widthPx + x) * 4, shot, point, gain, light);
      }
    }
  }
  const data = new Uint8ClampedArray(widthPx * heightPx * 4);
  for (let i = 0; i < data.length; i += 4) if ((sums[i + 3] ?? 0) > 0) data[i + 3] = 255;
  yield;
  fillHoles(sums, widthPx, heightPx);
  yield;
  encode(data, sums);
  return { widthPx, heightPx, channels: 4, data, holesPart: 1 - seenPart, overlapPart, evened };
}

function addSample(
  sums: Float32Array,
  at: number,
  { data, widthPx, heightPx }: PanoramaShot,
  point: ShotPoint,
  gain: readonly number[],
  light: Float32Array,
): void {
  const u = Math.min(Math.max(((point.x + 1) / 2) * widthPx - 0.5, 0), widthPx - 1);
  const v = Math.min(Math.max(((point.y + 1) / 2) * heightPx - 0.5, 0), heightPx - 1);
  const [column, row] = [Math.floor(u), Math.floor(v)];
  const [s, t] = [u - column, v - row];
  const first = (row * widthPx + column) * 4;
  const right = column + 1 < widthPx ? 4 : 0;
  const above = row + 1 < heightPx ? widthPx * 4 : 0;
  const nearest = first + (s > 0.5 ? right : 0) + (t > 0.5 ? above : 0);
  const brightest = Math.max(data[nearest] ?? 0, data[nearest + 1] ?? 0, data[nearest + 2] ?? 0);
  const weight = (edgeWeight(point) + 1e-6) * (brightest >= 253 || brightest <= 2 ? CLIPPED_WEIGHT : 1);
  // White means that brightness or more, so that a gain never darkens it.
  const isWhite = Math.min(data[nearest] ?? 0, data[nearest + 1] ?? 0, data[nearest + 2] ?? 0) >= WHITE;
  for (let c = 0; c < 3; c++) {
    const below = (light[data[first + c] ?? 0] ?? 0) * (1 - s) + (light[data[first + right + c] ?? 0] ?? 0) * s;
    const over = (light[data[first + above + c] ?? 0] ?? 0) * (1 - s) + (light[data[first + above + right + c] ?? 0] ?? 0) * s;
    sums[at + c] = (sums[at + c] ?? 0) + weight * (isWhite ? Math.max(gain[c] ?? 1, 1) : (gain[c] ?? 1)) * (below * (1 - t) + over * t);
  }
  sums[at + 3] = (sums[at + 3] ?? 0) + weight;
}

/** Sine and cosine of the longitude of each column, measured to the right of −z. */
function anglesOf(widthPx: number): [sines: Float64Array, cosines: Float64Array] {
  const angles = Float64Array.from({ length: widthPx }, (_, x) => ((x + 0.5) / widthPx) * 2 * Math.PI - Math.PI);
  return [angles.map(Math.sin), angles.map(Math.cos)];
}

/** A table of the linear radiance of each byte of sRGB. */
export function linearTable(): Float32Array {
  return Float32Array.from({ length: 256 }, (_, byte) => linearFromSrgb(byte / 255));
}

function encode(data: Uint8ClampedArray, sums: Float32Array): void {
  // 4096 steps of the square root are finer than a byte everywhere.
  const table = Uint8Array.from({ length: 4097 }, (_, i) => Math.round(255 * srgbFromLinear((i / 4096) ** 2)));
  for (let i = 0; i < data.length; i++) {
    if (i % 4 === 3) continue;
    data[i] = table[Math.round(Math.sqrt(Math.min(Math.max(sums[i] ?? 0, 0), 1)) * 4096)] ?? 0;
  }
}
