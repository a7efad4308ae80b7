import type { CpuParams, Pixels } from '../../kit/cpu-filter.ts';
import type { definition } from './definition.ts';

/**
 * Holds the number of pixels at each of the 256 brightness values, and then the new value for each. All calls share the array: a worker
 * processes one image at a time.
 */
const scratchCounts = new Uint32Array(256);
const scratchTable = new Uint8Array(256);

/**
 * Histogram equalization as OpenCV's `equalizeHist`: the new value of a pixel is the fraction of pixels that are at most as bright,
 * without those of the darkest value, which becomes 0 (Gonzalez and Woods, "Digital Image Processing", §3.3). Brightness is the Y of
 * YCbCr (BT.601); adding its change to red, green and blue keeps Cb and Cr.
 */
export function process({ data }: Pixels, { amount, spread }: CpuParams<typeof definition>): void {
  if (spread === 0) {
    equalize(data, luma);
    for (let i = 0; i < data.length; i += 4) {
      const alpha = data[i + 3] ?? 0;
      if (alpha === 0) continue;
      const before = luma(data, i);
      const change = ((scratchTable[before] ?? 0) - before) * amount;
      for (let c = 0; c < 3; c++) write(data, i + c, straight(data, i + c, alpha) + change, alpha);
    }
    return;
  }
  for (let c = 0; c < 3; c++) {
    const valueAt = (pixels: Uint8Array, i: number): number => Math.round(straight(pixels, i + c, pixels[i + 3] ?? 0));
    equalize(data, valueAt);
    for (let i = 0; i < data.length; i += 4) {
      const alpha = data[i + 3] ?? 0;
      if (alpha === 0) continue;
      const before = valueAt(data, i);
      write(data, i + c, before + ((scratchTable[before] ?? 0) - before) * amount, alpha);
    }
  }
}

/** Computes the table of new values from the histogram of the pixels that are not transparent. */
function equalize(data: Uint8Array, valueAt: (data: Uint8Array, i: number) => number): void {
  scratchCounts.fill(0);
  let total = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] === 0) continue;
    const value = valueAt(data, i);
    scratchCounts[value] = (scratchCounts[value] ?? 0) + 1;
    total++;
  }
  const darkest = scratchCounts.findIndex((count) => count > 0);
  const above = total - (scratchCounts[darkest] ?? 0);
  let sum = 0;
  for (let value = 0; value < 256; value++) {
    if (value > darkest) sum += scratchCounts[value] ?? 0;
    // An image with a single value does not change.
    scratchTable[value] = above === 0 ? value : Math.round((sum * 255) / above);
  }
}

/** Luma (BT.601) of a color with straight alpha. */
function luma(data: Uint8Array, i: number): number {
  const alpha = data[i + 3] ?? 0;
  return Math.round(0.299 * straight(data, i, alpha) + 0.587 * straight(data, i + 1, alpha) + 0.114 * straight(data, i + 2, alpha));
}

function straight(data: Uint8Array, i: number, alpha: number): number {
  const value = data[i] ?? 0;
  return alpha === 255 || alpha === 0 ? value : Math.min((value * 255) / alpha, 255);
}

/** Clamps a straight channel value, multiplies it by alpha again and stores it. */
function write(data: Uint8Array, i: number, value: number, alpha: number): void {
  data[i] = Math.round((Math.min(Math.max(value, 0), 255) * alpha) / 255);
}
