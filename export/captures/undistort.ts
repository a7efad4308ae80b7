import { CaptureError, type Pinhole } from '../../nodes/kit/capture.ts';
import { isDistorted, type Lens, project, unproject } from './lens.ts';

/** 8-bit RGBA, rows from the top. */
export interface Photo {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly data: Uint8Array;
}

const SAMPLES = 64;
/** Distance of two samples of a reduced photograph, in its own pixels: each bilinear sample reaches 1 pixel far, so every pixel counts. */
const SAMPLE_PX = 1.25;

/**
 * The pinhole camera that shows the largest upright rectangle of which the lens sees every point, as COLMAP's undistorter does without
 * blank pixels. A photograph larger than `maxSidePx` is reduced.
 *
 * @throws CaptureError if the lens has no such rectangle.
 */
export function pinholeFor(lens: Lens, maxSidePx: number): Pinhole {
  const factor = Math.min(1, maxSidePx / Math.max(lens.widthPx, lens.heightPx));
  const widthPx = Math.max(1, Math.round(lens.widthPx * factor));
  const heightPx = Math.max(1, Math.round(lens.heightPx * factor));
  if (!isDistorted(lens)) {
    const sx = widthPx / lens.widthPx;
    const sy = heightPx / lens.heightPx;
    const focus = { fxPx: lens.fxPx * sx, fyPx: lens.fyPx * sy, cxPx: lens.cxPx * sx, cyPx: lens.cyPx * sy };
    return { ...(lens.projection === 'equirectangular' ? { projection: lens.projection } : {}), widthPx, heightPx, ...focus };
  }
  const { left, right, top, bottom } = innerRectangle(lens);
  if (!(left < right && top < bottom)) throw new CaptureError('the distortion of a camera cannot be removed');
  const fxPx = widthPx / (right - left);
  const fyPx = heightPx / (bottom - top);
  return { widthPx, heightPx, fxPx, fyPx, cxPx: -left * fxPx, cyPx: -top * fyPx };
}

function innerRectangle(lens: Lens) {
  const out = new Float64Array(2);
  const rectangle = {
    left: Number.NEGATIVE_INFINITY,
    right: Number.POSITIVE_INFINITY,
    top: Number.NEGATIVE_INFINITY,
    bottom: Number.POSITIVE_INFINITY,
  };
  for (let i = 0; i <= SAMPLES; i++) {
    const column = (i / SAMPLES) * lens.widthPx;
    const row = (i / SAMPLES) * lens.heightPx;
    unproject(lens, 0, row, out);
    rectangle.left = Math.max(rectangle.left, out[0] ?? Number.NaN);
    unproject(lens, lens.widthPx, row, out);
    rectangle.right = Math.min(rectangle.right, out[0] ?? Number.NaN);
    unproject(lens, column, 0, out);
    rectangle.top = Math.max(rectangle.top, out[1] ?? Number.NaN);
    unproject(lens, column, lens.heightPx, out);
    rectangle.bottom = Math.min(rectangle.bottom, out[1] ?? Number.NaN);
  }
  return rectangle;
}

/**
 * Draws the photograph of a lens as a pinhole camera sees it: bilinear, and the mean of several samples where it is reduced. The lens is
 * computed at the corners of the pixels only; between them, it is off by less than a hundredth of a pixel.
 */
export function resample(photo: Photo, lens: Lens, pinhole: Pinhole): Photo {
  const { widthPx, heightPx } = pinhole;
  const from = photo.data;
  const [lastColumn, lastRow] = [photo.widthPx - 1, photo.heightPx - 1];
  const rowLength = 4 * photo.widthPx;
  const data = new Uint8Array(widthPx * heightPx * 4);
  const perSide = Math.max(1, Math.ceil(lens.widthPx / widthPx / SAMPLE_PX));
  const samples = perSide * perSide;
  let above = new Float64Array(2 * widthPx + 2);
  let below = cornersOf(lens, pinhole, 0, new Float64Array(2 * widthPx + 2));
  for (let row = 0; row < heightPx; row++) {
    [above, below] = [below, cornersOf(lens, pinhole, row + 1, above)];
    for (let column = 0; column < widthPx; column++) {
      const corner = 2 * column;
      let red = 0;
      let green = 0;
      let blue = 0;
      for (let j = 0; j < perSide; j++) {
        const down = (j + 0.5) / perSide;
        const startX = mix(above[corner] ?? 0, below[corner] ?? 0, down);
        const startY = mix(above[corner + 1] ?? 0, below[corner + 1] ?? 0, down);
        const stepX = (mix(above[corner + 2] ?? 0, below[corner + 2] ?? 0, down) - startX) / perSide;
        const stepY = (mix(above[corner + 3] ?? 0, below[corner + 3] ?? 0, down) - startY) / perSide;
        for (let i = 0; i < perSide; i++) {
          // Places outside have the color of the edge.
          const x = Math.min(Math.max(startX + (i + 0.5) * stepX - 0.5, 0), lastColumn);
          const y = Math.min(Math.max(startY + (i + 0.5) * stepY - 0.5, 0), lastRow);
          const left = x | 0;
          const top = y | 0;
          const fx = x - left;
          const fy = y - top;
          const a = top * rowLength + 4 * left;
          const b = left < lastColumn ? a + 4 : a;
          const c = top < lastRow ? a + rowLength : a;
          const d = c + b - a;
          const wd = fx * fy;
          const wb = fx - wd;
          const wc = fy - wd;
          const wa = 1 - fx - wc;
          // Written out, because this is most of the time of an import.
          red += (from[a] ?? 0) * wa + (from[b] ?? 0) * wb + (from[c] ?? 0) * wc + (from[d] ?? 0) * wd;
          green += (from[a + 1] ?? 0) * wa + (from[b + 1] ?? 0) * wb + (from[c + 1] ?? 0) * wc + (from[d + 1] ?? 0) * wd;
          blue += (from[a + 2] ?? 0) * wa + (from[b + 2] ?? 0) * wb + (from[c + 2] ?? 0) * wc + (from[d + 2] ?? 0) * wd;
        }
      }
      const at = 4 * (row * widthPx + column);
      data[at] = Math.round(red / samples);
      data[at + 1] = Math.round(green / samples);
      data[at + 2] = Math.round(blue / samples);
      data[at + 3] = 255;
    }
  }
  return { widthPx, heightPx, data };
}

/** Where the lens shows the upper corners of a row of pixels, column and row by turns. */
function cornersOf(
  lens: Lens,
  { widthPx, fxPx, fyPx, cxPx, cyPx }: Pinhole,
  row: number,
  out: Float64Array<ArrayBuffer>,
): Float64Array<ArrayBuffer> {
  const place = new Float64Array(2);
  for (let column = 0; column <= widthPx; column++) {
    project(lens, (column - cxPx) / fxPx, (row - cyPx) / fyPx, place);
    out[2 * column] = place[0] ?? 0;
    out[2 * column + 1] = place[1] ?? 0;
  }
  return out;
}

function mix(a: number, b: number, share: number): number {
  return a + (b - a) * share;
}
