/** Pixels of an image: RGBA, 8 bits, display-referred sRGB, rows from the top. */
export interface ImagePixels {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly pixels: ArrayLike<number>;
}

/** Luma of each pixel with the coefficients of BT.709, from 0 to 255. */
export function lumaOf({ widthPx, heightPx, pixels }: ImagePixels): Float32Array {
  const luma = new Float32Array(widthPx * heightPx);
  for (let i = 0; i < luma.length; i++) {
    luma[i] = 0.2126 * (pixels[4 * i] ?? 0) + 0.7152 * (pixels[4 * i + 1] ?? 0) + 0.0722 * (pixels[4 * i + 2] ?? 0);
  }
  return luma;
}

/** The mean of the square of 2 · `radiusPx` + 1 pixels around each value, row-major. Beyond the border, the value at the border counts. */
export function smoothed(values: ArrayLike<number>, widthPx: number, heightPx: number, radiusPx: number): Float32Array {
  const rows = new Float32Array(widthPx * heightPx);
  for (let y = 0; y < heightPx; y++) smoothLine(values, rows, y * widthPx, 1, widthPx, radiusPx);
  const both = new Float32Array(widthPx * heightPx);
  for (let x = 0; x < widthPx; x++) smoothLine(rows, both, x, widthPx, heightPx, radiusPx);
  return both;
}

function smoothLine(from: ArrayLike<number>, to: Float32Array, start: number, step: number, count: number, radius: number): void {
  const at = (i: number): number => from[start + step * Math.min(Math.max(i, 0), count - 1)] ?? 0;
  let sum = 0;
  for (let i = -radius; i <= radius; i++) sum += at(i);
  for (let i = 0; i < count; i++) {
    to[start + step * i] = sum / (2 * radius + 1);
    sum += at(i + radius + 1) - at(i - radius);
  }
}

/** Mean difference of strokes and other details from the tone around them, in steps of 8 bits. */
export function contrastOf(image: ImagePixels, radiusPx: number): number {
  const luma = lumaOf(image);
  const tone = smoothed(luma, image.widthPx, image.heightPx, radiusPx);
  return luma.reduce((sum, value, i) => sum + Math.abs(value - (tone[i] ?? 0)), 0) / luma.length;
}
