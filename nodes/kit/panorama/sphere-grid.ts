import { linearFromSrgb } from '../color-math.ts';
import { createRowReader, isDisplayReferred, type PanoramaPixels, ROWS_PER_STEP } from './pixels.ts';

/** A panorama scaled to at most 1024 × 512 pixels, with the solid angle of its pixels. */
export interface SphereGrid {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Linear-sRGB radiance, rows from the top. */
  readonly radiance: Float32Array;
  readonly luminance: Float32Array;
  /** For each row, the solid angle of one of its pixels, steradians. */
  readonly pixelSr: Float64Array;
  /** For each pixel, the fraction of its area that is clipped to white; null for panoramas of radiance. */
  readonly clipped: Float32Array | null;
  readonly damaged: number;
}

/** Greatest width: at 0.35° per pixel, the sun still covers a pixel. A larger grid would change neither directions nor energy. */
const MAX_WIDTH_PX = 1024;
/** Bytes of sRGB from this value on count as clipped, because compression lowers white to a little less than 255. */
const CLIPPED_BYTE = 250;
/** Rec. 709 luminance of linear sRGB. */
const [RED, GREEN, BLUE] = [0.2126, 0.7152, 0.0722] as const;

/**
 * The luminance of linear-sRGB radiance.
 *
 * @example
 * luminanceOf(1, 1, 1); // 1
 */
export function luminanceOf(red: number, green: number, blue: number): number {
  return RED * red + GREEN * green + BLUE * blue;
}

/** Averages a panorama in linear light to a grid. It yields after about a millisecond of work. */
export function* sphereGridOf(pixels: PanoramaPixels): Generator<undefined, SphereGrid> {
  const step = Math.ceil(pixels.widthPx / MAX_WIDTH_PX);
  const widthPx = Math.ceil(pixels.widthPx / step);
  const heightPx = Math.ceil(pixels.heightPx / step);
  const radiance = new Float32Array(widthPx * heightPx * 3);
  const clipped = isDisplayReferred(pixels) ? new Float32Array(widthPx * heightPx) : null;
  const limit = linearFromSrgb(CLIPPED_BYTE / 255);
  const rows = createRowReader(pixels);
  const row = new Float32Array(pixels.widthPx * 3);
  for (let y = 0; y < pixels.heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    rows.read(y, row);
    let i = Math.floor(y / step) * widthPx;
    for (let x = 0, inPixel = 0; x < pixels.widthPx; x++) {
      const [red, green, blue] = [row[x * 3] ?? 0, row[x * 3 + 1] ?? 0, row[x * 3 + 2] ?? 0];
      radiance[i * 3] = (radiance[i * 3] ?? 0) + red;
      radiance[i * 3 + 1] = (radiance[i * 3 + 1] ?? 0) + green;
      radiance[i * 3 + 2] = (radiance[i * 3 + 2] ?? 0) + blue;
      if (clipped && red >= limit && green >= limit && blue >= limit) clipped[i] = (clipped[i] ?? 0) + 1;
      if (++inPixel === step) {
        inPixel = 0;
        i++;
      }
    }
  }
  const luminance = new Float32Array(widthPx * heightPx);
  for (let y = 0; y < heightPx; y++) {
    if (y % ROWS_PER_STEP === 0) yield;
    // The last row and column may average fewer pixels.
    const down = Math.min(step, pixels.heightPx - y * step);
    for (let x = 0, i = y * widthPx; x < widthPx; x++, i++) {
      const part = 1 / (Math.min(step, pixels.widthPx - x * step) * down);
      for (let c = i * 3; c < i * 3 + 3; c++) radiance[c] = (radiance[c] ?? 0) * part;
      if (clipped) clipped[i] = (clipped[i] ?? 0) * part;
      luminance[i] = luminanceOf(radiance[i * 3] ?? 0, radiance[i * 3 + 1] ?? 0, radiance[i * 3 + 2] ?? 0);
    }
  }
  return { widthPx, heightPx, radiance, luminance, pixelSr: solidAngles(widthPx, heightPx), clipped, damaged: rows.damaged };
}

function solidAngles(widthPx: number, heightPx: number): Float64Array {
  const sineAt = (row: number): number => Math.cos((row / heightPx) * Math.PI);
  return Float64Array.from({ length: heightPx }, (_, y) => ((2 * Math.PI) / widthPx) * (sineAt(y) - sineAt(y + 1)));
}
