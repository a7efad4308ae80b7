import type { Sum } from './mean-of.ts';
import type { ImagePixels } from './smooth.ts';

/** A pinhole camera in pixels of the image, y down; the center of the top left pixel is (0.5, 0.5). */
export interface ShotCamera {
  readonly fxPx: number;
  readonly fyPx: number;
  readonly cxPx: number;
  readonly cyPx: number;
}

/** Where a frame was taken and how far what it shows is. */
export interface Shot {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly camera: ShotCamera;
  /** Rigid, column-major 4×4, looking along −z. */
  readonly worldFromCamera: ArrayLike<number>;
  /** Meters along the axis of the camera, 0 where unknown; row-major, rows from the top. */
  readonly depthM: ArrayLike<number>;
}

/** Depths that differ by less than this share are of one surface. */
const SAME_SURFACE = 0.02;

/**
 * The difference between a frame and the previous frame, moved by the true motion of what it shows: the mean over red, green and blue
 * per pixel, in steps of 8 bits. The motion follows from depth and poses, so it is true of all that stands still. Pixels that the
 * previous frame did not see, that are at the border of a surface there, or whose depth is unknown do not count.
 *
 * The measure is the warping error of Lai et al. 2018, “Learning Blind Video Temporal Consistency”, §4.3, with the true flow.
 */
export function flickerBetween(before: Shot, imageBefore: ImagePixels, now: Shot, imageNow: ImagePixels): Sum {
  const { widthPx, heightPx } = now;
  const beforeFromNow = relativePose(before.worldFromCamera, now.worldFromCamera);
  const [a, b] = [imageBefore.pixels, imageNow.pixels];
  let [sum, count] = [0, 0];
  for (let i = 0; i < widthPx * heightPx; i++) {
    const at = seenBefore(before, now, beforeFromNow, i);
    if (at === null) continue;
    const { corner, u, v } = at;
    const right = corner + 4;
    const below = corner + 4 * widthPx;
    for (let c = 0; c < 3; c++) {
      const above = (1 - u) * (a[corner + c] ?? 0) + u * (a[right + c] ?? 0);
      const under = (1 - u) * (a[below + c] ?? 0) + u * (a[below + 4 + c] ?? 0);
      sum += Math.abs((1 - v) * above + v * under - (b[4 * i + c] ?? 0)) / 3;
    }
    count++;
  }
  return { sum, count };
}

/** The four pixels around a point: the index of the top left one's red, and where the point is between their centers. Reused. */
const place = { corner: 0, u: 0, v: 0 };

/** Where the previous frame shows what the pixel `i` shows now, or null if it does not. */
function seenBefore(before: Shot, now: Shot, m: Float64Array, i: number): typeof place | null {
  const depth = now.depthM[i] ?? 0;
  if (depth <= 0) return null;
  const { widthPx, heightPx } = now;
  const x = (((i % widthPx) + 0.5 - now.camera.cxPx) / now.camera.fxPx) * depth;
  const y = ((now.camera.cyPx - Math.floor(i / widthPx) - 0.5) / now.camera.fyPx) * depth;
  const row = (r: number): number => (m[r] ?? 0) * x + (m[r + 4] ?? 0) * y - (m[r + 8] ?? 0) * depth + (m[r + 12] ?? 0);
  const away = -row(2);
  if (away <= 0) return null;
  // From pixel centers. Rounding must not push what has not moved out of the image.
  const column = steady(before.camera.cxPx + (before.camera.fxPx * row(0)) / away - 0.5);
  const line = steady(before.camera.cyPx - (before.camera.fyPx * row(1)) / away - 0.5);
  if (!(column >= 0 && line >= 0 && column <= widthPx - 1 && line <= heightPx - 1)) return null;
  const left = Math.min(Math.floor(column), widthPx - 2);
  const top = Math.min(Math.floor(line), heightPx - 2);
  const first = top * widthPx + left;
  for (const corner of [first, first + 1, first + widthPx, first + widthPx + 1]) {
    if (Math.abs((before.depthM[corner] ?? 0) / away - 1) > SAME_SURFACE) return null;
  }
  place.corner = 4 * first;
  place.u = column - left;
  place.v = line - top;
  return place;
}

function steady(x: number): number {
  const whole = Math.round(x);
  return Math.abs(x - whole) < 1e-4 ? whole : x;
}

/** The pose of `now` in the space of `before`; both rigid, column-major 4×4. */
function relativePose(before: ArrayLike<number>, now: ArrayLike<number>): Float64Array {
  const out = new Float64Array(16);
  for (let column = 0; column < 4; column++) {
    for (let r = 0; r < 3; r++) {
      let sum = 0;
      for (let k = 0; k < 3; k++) {
        const from = (now[4 * column + k] ?? 0) - (column === 3 ? (before[12 + k] ?? 0) : 0);
        sum += (before[4 * r + k] ?? 0) * from;
      }
      out[4 * column + r] = sum;
    }
  }
  out[15] = 1;
  return out;
}
