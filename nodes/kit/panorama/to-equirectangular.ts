import { type ImagePoint, type PanoramaLayout, placeOf } from './layouts.ts';
import { type PanoramaPixels, startOfRow } from './pixels.ts';

/** The largest half float; infinite radiance counts as this much. */
const MAX_RADIANCE = 65504;

/** Panorama pixels whose array interpolation can write: no half floats. */
export type PlainPixels = PanoramaPixels & { readonly data: Float32Array | Uint8Array | Uint8ClampedArray };

/**
 * Converts a photo of a mirror ball or the faces of a cube to an equirectangular panorama, with the sharpness of the image.
 *
 * @param mostPx Greatest width of the result.
 * @returns Rows from the top, in an array of the same type.
 *
 * @example
 * const panorama = toEquirectangular(pixels, 'cross');
 */
export function toEquirectangular(pixels: PlainPixels, layout: PanoramaLayout, mostPx = Number.POSITIVE_INFINITY): PlainPixels {
  const { channels } = pixels;
  const widthPx = Math.min(widthFor(layout, pixels), mostPx);
  const heightPx = widthPx / 2;
  const count = widthPx * heightPx * channels;
  const data = pixels.data instanceof Float32Array ? new Float32Array(count) : new Uint8ClampedArray(count);
  const at: ImagePoint = { x: 0, y: 0, left: 0, top: 0, right: 0, bottom: 0 };
  for (let row = 0; row < heightPx; row++) {
    const elevation = Math.PI / 2 - ((row + 0.5) / heightPx) * Math.PI;
    const [up, level] = [Math.sin(elevation), Math.cos(elevation)];
    for (let column = 0; column < widthPx; column++) {
      const longitude = ((column + 0.5) / widthPx) * 2 * Math.PI - Math.PI;
      placeOf(at, layout, pixels.widthPx, pixels.heightPx, level * Math.sin(longitude), up, -level * Math.cos(longitude));
      interpolate(data, (row * widthPx + column) * channels, pixels, at);
    }
  }
  return { widthPx, heightPx, channels, data };
}

/**
 * The width of an equirectangular panorama as sharp as the image: four times that of a cube's face, which shows a quarter of the horizon;
 * that of a ball's image, whose middle half shows a mirrored view of 90°.
 */
function widthFor(layout: PanoramaLayout, { widthPx, heightPx }: PanoramaPixels): number {
  const faces = { equirectangular: widthPx, ball: widthPx, cross: widthPx, 'cross-upright': heightPx, strip: (widthPx / 6) * 4 };
  const wanted = layout === 'strip-upright' ? (heightPx / 6) * 4 : faces[layout];
  return Math.max(2, Math.round(wanted / 2) * 2);
}

function interpolate(data: Float32Array | Uint8ClampedArray, to: number, pixels: PlainPixels, at: ImagePoint): void {
  const x = Math.min(Math.max(at.x, at.left + 0.5), at.right - 0.5) - 0.5;
  const y = Math.min(Math.max(at.y, at.top + 0.5), at.bottom - 0.5) - 0.5;
  const [column, row] = [Math.max(Math.floor(x), 0), Math.max(Math.floor(y), 0)];
  const [right, below] = [Math.min(column + 1, pixels.widthPx - 1), Math.min(row + 1, pixels.heightPx - 1)];
  const [s, t] = [Math.max(x - column, 0), Math.max(y - row, 0)];
  const [upper, lower] = [startOfRow(pixels, row), startOfRow(pixels, below)];
  for (let c = 0; c < pixels.channels; c++) {
    const first = read(pixels, upper + column * pixels.channels + c) * (1 - s) + read(pixels, upper + right * pixels.channels + c) * s;
    const second = read(pixels, lower + column * pixels.channels + c) * (1 - s) + read(pixels, lower + right * pixels.channels + c) * s;
    data[to + c] = first * (1 - t) + second * t;
  }
}

/**
 * Reads a number of the image. Infinity becomes the largest half float and other invalid numbers 0, so that one such pixel does not spread
 * to its neighbors.
 */
function read({ data }: PlainPixels, i: number): number {
  const value = data[i] ?? 0;
  return Number.isFinite(value) ? value : value > 0 ? MAX_RADIANCE : 0;
}
