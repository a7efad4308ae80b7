import { CaptureError, type Pinhole } from '../../nodes/kit/capture.ts';
import { isDistorted, type Lens, project, unproject } from './lens.ts';

/** 8-bit RGBA, rows from the top. */
export interface Photo {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly data: Uint8Array;
}

const SAMPLES = 64;

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
  const data = new Uint8Array(widthPx * heightPx * 4);
  const place = new Float64Array(2);
  const perSide = Math.max(1, Math.round(lens.widthPx / widthPx));
  const sum = new Float64Array(3);
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      sum.fill(0);
      for (let sample = 0; sample < perSide * perSide; sample++) {
        const sx = ((sample % perSide) + 0.5) / perSide;
        const sy = (Math.floor(sample / perSide) + 0.5) / perSide;
        project(lens, (column + sx - pinhole.cxPx) / pinhole.fxPx, (row + sy - pinhole.cyPx) / pinhole.fyPx, place);
        addBilinear(photo, (place[0] ?? 0) - 0.5, (place[1] ?? 0) - 0.5, sum);
      }
      const at = (row * widthPx + column) * 4;
      for (let c = 0; c < 3; c++) data[at + c] = Math.round((sum[c] ?? 0) / (perSide * perSide));
      data[at + 3] = 255;
    }
  }
  return { widthPx, heightPx, data };
}

/** Adds the color between four pixel centers to `sum`. Places outside have the color of the edge. */
function addBilinear({ widthPx, heightPx, data }: Photo, x: number, y: number, sum: Float64Array): void {
  const column = Math.min(Math.max(x, 0), widthPx - 1);
  const row = Math.min(Math.max(y, 0), heightPx - 1);
  const left = Math.floor(column);
  const top = Math.floor(row);
  const fx = column - left;
  const fy = row - top;
  const right = Math.min(left + 1, widthPx - 1);
  const bottom = Math.min(top + 1, heightPx - 1);
  for (let c = 0; c < 3; c++) {
    const a = data[(top * widthPx + left) * 4 + c] ?? 0;
    const b = data[(top * widthPx + right) * 4 + c] ?? 0;
    const d = data[(bottom * widthPx + left) * 4 + c] ?? 0;
    const e = data[(bottom * widthPx + right) * 4 + c] ?? 0;
    sum[c] = (sum[c] ?? 0) + (a * (1 - fx) + b * fx) * (1 - fy) + (d * (1 - fx) + e * fx) * fy;
  }
}
