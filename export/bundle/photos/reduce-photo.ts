import type { Photo } from '../../captures/undistort.ts';

const REDUCED_SIDE_PX = 640;

/** Reduces a photograph to at most 640 pixels. Each pixel is the mean of about as many by as many pixels; every pixel counts once. */
export function reducePhoto({ data, widthPx, heightPx }: Photo): Photo {
  const factor = Math.ceil(Math.max(widthPx, heightPx) / REDUCED_SIDE_PX);
  const width = Math.max(1, Math.round(widthPx / factor));
  const height = Math.max(1, Math.round(heightPx / factor));
  const from = (at: number, count: number, sizePx: number): number => Math.round((at * sizePx) / count);
  const reduced = new Uint8Array(4 * width * height).fill(255);
  for (let y = 0; y < height; y++) {
    const [top, bottom] = [from(y, height, heightPx), from(y + 1, height, heightPx)];
    for (let x = 0; x < width; x++) {
      const [left, right] = [from(x, width, widthPx), from(x + 1, width, widthPx)];
      let [red, green, blue] = [0, 0, 0];
      for (let row = top; row < bottom; row++) {
        for (let at = 4 * (row * widthPx + left); at < 4 * (row * widthPx + right); at += 4) {
          red += data[at] ?? 0;
          green += data[at + 1] ?? 0;
          blue += data[at + 2] ?? 0;
        }
      }
      const count = (bottom - top) * (right - left);
      reduced.set([Math.round(red / count), Math.round(green / count), Math.round(blue / count)], 4 * (y * width + x));
    }
  }
  return { widthPx: width, heightPx: height, data: reduced };
}
