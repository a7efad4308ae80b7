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

/** Draws the photograph of a lens as a pinhole camera sees it: bilinear, and the mean of several samples where it is reduced. */
export function resample(photo: Photo, lens: Lens, pinhole: Pinhole): Photo {
  const { widthPx, heightPx } = pinhole;
  const from = photo.data;
  const [lastColumn, lastRow] = [photo.widthPx - 1, photo.heightPx - 1];
  const data = new Uint8Array(widthPx * heightPx * 4);
  const place = new Float64Array(2);
  const perSide = Math.max(1, Math.ceil(lens.widthPx / widthPx / SAMPLE_PX));
  const samples = perSide * perSide;
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      let red = 0;
      let green = 0;
      let blue = 0;
      for (let sample = 0; sample < samples; sample++) {
        const sx = ((sample % perSide) + 0.5) / perSide;
        const sy = (Math.floor(sample / perSide) + 0.5) / perSide;
        project(lens, (column + sx - pinhole.cxPx) / pinhole.fxPx, (row + sy - pinhole.cyPx) / pinhole.fyPx, place);
        // Places outside have the color of the edge.
        const x = Math.min(Math.max((place[0] ?? 0) - 0.5, 0), lastColumn);
        const y = Math.min(Math.max((place[1] ?? 0) - 0.5, 0), lastRow);
        const left = Math.floor(x);
        const top = Math.floor(y);
        const fx = x - left;
        const fy = y - top;
        const a = 4 * (top * photo.widthPx + left);
        const b = left < lastColumn ? a + 4 : a;
        const down = top < lastRow ? 4 * photo.widthPx : 0;
        const c = a + down;
        const d = b + down;
        const wa = (1 - fx) * (1 - fy);
        const wb = fx * (1 - fy);
        const wc = (1 - fx) * fy;
        const wd = fx * fy;
        // Written out, because this is most of the time of an import.
        red += (from[a] ?? 0) * wa + (from[b] ?? 0) * wb + (from[c] ?? 0) * wc + (from[d] ?? 0) * wd;
        green += (from[a + 1] ?? 0) * wa + (from[b + 1] ?? 0) * wb + (from[c + 1] ?? 0) * wc + (from[d + 1] ?? 0) * wd;
        blue += (from[a + 2] ?? 0) * wa + (from[b + 2] ?? 0) * wb + (from[c + 2] ?? 0) * wc + (from[d + 2] ?? 0) * wd;
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
