import { srgbFromLinear } from '../color-math.ts';
import { createRowReader, isDisplayReferred, type PanoramaPixels, ROWS_PER_STEP, startOfRow } from './pixels.ts';

/** A panorama as bytes of gray. */
export interface GrayImage {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Rows from the top. */
  readonly gray: Uint8Array;
  /** Pixels whose radiance is not a number, infinite or negative. */
  readonly damaged: number;
}

/** The exposure is chosen so that this fraction of the pixels is not brighter than white; the rest is clipped. */
const EXPOSED_PART = 0.999;

/** Weights of BT.601 in 15 bits, as `cv::cvtColor` has them. */
const [RED, GREEN, BLUE] = [9798, 19235, 3735] as const;

/**
 * Converts a panorama to gray as the first step of the paper's method does (ARPAS 2018, section 3.2). Display-referred pixels are weighted
 * as they are stored. Radiance is weighted in linear light, exposed so that 99.9 % of the pixels are not clipped, and encoded to sRGB.
 */
export function* grayImageOf(pixels: PanoramaPixels): Generator<undefined, GrayImage> {
  return isDisplayReferred(pixels) ? yield* grayOfBytes(pixels) : yield* grayOfRadiance(pixels);
}

function* grayOfBytes(pixels: PanoramaPixels): Generator<undefined, GrayImage> {
  const { widthPx, heightPx, data, channels } = pixels;
  const gray = new Uint8Array(widthPx * heightPx);
  for (let y = 0, i = 0; y < heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    let from = startOfRow(pixels, y);
    for (let x = 0; x < widthPx; x++, from += channels) {
      if (channels === 1) gray[i++] = data[from] ?? 0;
      else gray[i++] = ((data[from] ?? 0) * RED + (data[from + 1] ?? 0) * GREEN + (data[from + 2] ?? 0) * BLUE + 16384) >> 15;
    }
  }
  return { widthPx, heightPx, gray, damaged: 0 };
}

function* grayOfRadiance(pixels: PanoramaPixels): Generator<undefined, GrayImage> {
  const { widthPx, heightPx } = pixels;
  const luminance = new Float32Array(widthPx * heightPx);
  const rows = createRowReader(pixels);
  const row = new Float32Array(widthPx * 3);
  for (let y = 0, i = 0; y < heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    rows.read(y, row);
    for (let from = 0; from < row.length; from += 3) {
      luminance[i++] = 0.299 * (row[from] ?? 0) + 0.587 * (row[from + 1] ?? 0) + 0.114 * (row[from + 2] ?? 0);
    }
  }
  const white = yield* quantile(luminance, EXPOSED_PART);
  const gray = new Uint8Array(luminance.length);
  const grayOf = createEncoder();
  const exposure = white > 0 ? 1 / white : 0;
  for (let i = 0; i < luminance.length; i++) {
    if (i % (widthPx * ROWS_PER_STEP) === 0) yield;
    gray[i] = grayOf((luminance[i] ?? 0) * exposure);
  }
  return { widthPx, heightPx, gray, damaged: rows.damaged };
}

/** Creates a function that encodes linear light to a byte of sRGB. It computes a power only near the limit between two bytes. */
function createEncoder(): (linear: number) => number {
  const steps = 16384;
  const table = Uint8Array.from({ length: steps + 1 }, (_, i) => encode(i / steps));
  return (linear) => {
    if (linear >= 1) return 255;
    const step = Math.floor(linear * steps);
    const below = table[step] ?? 0;
    return below === table[step + 1] ? below : encode(linear);
  };
}

function encode(linear: number): number {
  return Math.round(255 * srgbFromLinear(linear));
}

/**
 * A quantile of numbers that are not negative, interpolated between neighbors as in `numpy.percentile`. The bits of such floats, as
 * integers, have the same order as the floats, so counting their upper and then their lower halves replaces sorting.
 */
function* quantile(values: Float32Array, part: number): Generator<undefined, number> {
  const bits = new Uint32Array(values.buffer, values.byteOffset, values.length);
  const upper = new Uint32Array(0x10000);
  yield;
  for (const one of bits) upper[one >>> 16] = (upper[one >>> 16] ?? 0) + 1;
  yield;
  const rank = part * (values.length - 1);
  const low = nth(bits, upper, Math.floor(rank));
  const high = nth(bits, upper, Math.min(Math.floor(rank) + 1, values.length - 1));
  return low + (high - low) * (rank - Math.floor(rank));
}

function nth(bits: Uint32Array, upper: Uint32Array, index: number): number {
  let before = 0;
  let half = 0;
  while (half < 0xffff && before + (upper[half] ?? 0) <= index) before += upper[half++] ?? 0;
  const lower = new Uint32Array(0x10000);
  for (const one of bits) if (one >>> 16 === half) lower[one & 0xffff] = (lower[one & 0xffff] ?? 0) + 1;
  let rest = 0;
  while (rest < 0xffff && before + (lower[rest] ?? 0) <= index) before += lower[rest++] ?? 0;
  return new Float32Array(Uint32Array.of(((half << 16) | rest) >>> 0).buffer)[0] ?? 0;
}
