import { createRay, type Meeting, type Ray, toLocal, turnNormal } from '../ray.ts';

/** A picture of room depth on the CPU, with the view that it was taken for. */
export interface DepthPicture {
  /** Along the view's axis, meters, 0 where unknown; rows as in the texture. */
  meters: Float32Array;
  widthPx: number;
  heightPx: number;
  /** Column-major 3×3, homogeneous: texture UV from view UV. */
  readonly uvFromViewUv: Float32Array;
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  /** Index of the frame that it was taken in. */
  frame: number;
}

/** How far a ray is followed, meters along the view's axis. */
const NEAR_M = 0.05;
const FAR_M = 20;
/** Samples of one ray at most. */
const MAX_STEPS = 512;
/** Neighboring samples that differ by more than this share of the distance belong to two surfaces. */
const GAP = 0.1;
/** Half the side of the window that a normal is fitted to, samples. */
const WINDOW = 3;

// Filled and read within one call.
const scratchRay = createRay();
const scratchTexel = { x: 0, y: 0 };

/**
 * Follows a ray through a depth picture until it goes behind a surface. A ray that passes behind an edge, where depth jumps, goes on:
 * nobody knows what is there. Between samples 1 / depth is interpolated, which is exact for planes; the normal is that of the plane
 * that fits 1 / depth best around the hit.
 *
 * @returns False where it meets nothing; `out` is then as it was.
 */
export function castAtDepth(out: Meeting, ray: Ray, picture: DepthPicture): boolean {
  toLocal(scratchRay, ray, picture.worldFromView);
  const view = scratchRay;
  const [near, far] = clipToView(view, picture);
  if (!(far > near)) return false;
  const zNear = -(view.oz + view.dz * near);
  const zFar = -(view.oz + view.dz * far);
  const steps = Math.min(MAX_STEPS, Math.max(1, Math.ceil(pixelsBetween(view, near, far, picture) * 2)));
  let before = 0;
  let wasInFront = behind(view, near, picture) < 0;
  for (let i = 1; i <= steps; i++) {
    const s = i / steps;
    const gap = behind(view, distanceAt(s, near, far, zNear, zFar), picture);
    if (Number.isNaN(gap)) {
      wasInFront = false;
      continue;
    }
    if (gap >= 0 && wasInFront) {
      let low = before;
      let high = s;
      for (let k = 0; k < 40; k++) {
        const middle = (low + high) / 2;
        if (behind(view, distanceAt(middle, near, far, zNear, zFar), picture) < 0) low = middle;
        else high = middle;
      }
      const distanceM = distanceAt(high, near, far, zNear, zFar);
      const z = -(view.oz + view.dz * distanceM);
      if (Math.abs(behind(view, distanceM, picture)) <= 0.001 * z && fitNormal(out, view, distanceM, picture)) {
        out.distanceM = distanceM;
        turnNormal(out, picture.worldFromView);
        return true;
      }
    }
    wasInFront = gap < 0;
    before = s;
  }
  return false;
}

/** Even steps of `s` from 0 to 1 are even steps on the screen, because those are even in 1 / depth. */
function distanceAt(s: number, near: number, far: number, zNear: number, zFar: number): number {
  const a = (1 - s) / zNear;
  const b = s / zFar;
  return (near * a + far * b) / (a + b);
}

/** The part of a ray that the view sees, as distances along it. Filled and read within one call. */
const scratchRange: [near: number, far: number] = [0, 0];

function clipToView(ray: Ray, { clipFromView: c }: DepthPicture): readonly [number, number] {
  const p8 = c[8] ?? 0;
  const p9 = c[9] ?? 0;
  scratchRange[0] = 0;
  scratchRange[1] = Number.POSITIVE_INFINITY;
  // A ray from the eye runs along the sides of the view: a hair of slack keeps rays through its border.
  const slack = 1e-6;
  cut(ray, c[0] ?? 1, 0, p8 - 1 - slack, 0);
  cut(ray, -(c[0] ?? 1), 0, -p8 - 1 - slack, 0);
  cut(ray, 0, c[5] ?? 1, p9 - 1 - slack, 0);
  cut(ray, 0, -(c[5] ?? 1), -p9 - 1 - slack, 0);
  cut(ray, 0, 0, -1, -NEAR_M);
  cut(ray, 0, 0, 1, FAR_M);
  return scratchRange;
}

/** Keeps of the range what is in the half space a x + b y + d z + w >= 0. */
function cut(ray: Ray, a: number, b: number, d: number, w: number): void {
  const atOrigin = a * ray.ox + b * ray.oy + d * ray.oz + w;
  const slope = a * ray.dx + b * ray.dy + d * ray.dz;
  if (Math.abs(slope) < 1e-12) {
    if (atOrigin < 0) scratchRange[1] = -1;
    return;
  }
  const t = -atOrigin / slope;
  if (slope > 0) scratchRange[0] = Math.max(scratchRange[0], t);
  else scratchRange[1] = Math.min(scratchRange[1], t);
}

function pixelsBetween(ray: Ray, near: number, far: number, picture: DepthPicture): number {
  toTexel(ray, near, picture);
  const { x, y } = scratchTexel;
  toTexel(ray, far, picture);
  return Math.hypot(scratchTexel.x - x, scratchTexel.y - y);
}

/** Texture coordinates in samples, whose centers are at halves. */
function toTexel(
  { ox, oy, oz, dx, dy, dz }: Ray,
  distanceM: number,
  { clipFromView: c, uvFromViewUv: m, widthPx, heightPx }: DepthPicture,
): void {
  const z = -(oz + dz * distanceM);
  const u = (((c[0] ?? 1) * (ox + dx * distanceM)) / z - (c[8] ?? 0) + 1) / 2;
  const v = (((c[5] ?? 1) * (oy + dy * distanceM)) / z - (c[9] ?? 0) + 1) / 2;
  const w = (m[2] ?? 0) * u + (m[5] ?? 0) * v + (m[8] ?? 1);
  scratchTexel.x = (((m[0] ?? 0) * u + (m[3] ?? 0) * v + (m[6] ?? 0)) / w) * widthPx;
  scratchTexel.y = (((m[1] ?? 0) * u + (m[4] ?? 0) * v + (m[7] ?? 0)) / w) * heightPx;
}

/** How far a point of the ray is behind what the picture shows, along the view's axis; NaN where that is unknown. */
function behind(ray: Ray, distanceM: number, picture: DepthPicture): number {
  toTexel(ray, distanceM, picture);
  const depth = sample(picture, scratchTexel.x, scratchTexel.y);
  return depth > 0 ? -(ray.oz + ray.dz * distanceM) - depth : Number.NaN;
}

function sample({ meters, widthPx, heightPx }: DepthPicture, x: number, y: number): number {
  if (x < 0 || y < 0 || x > widthPx || y > heightPx) return 0;
  // Half a sample at the border continues the outermost two.
  const column = clamp(Math.floor(x - 0.5), 0, widthPx - 2);
  const row = clamp(Math.floor(y - 0.5), 0, heightPx - 2);
  const at = row * widthPx + column;
  const a = meters[at] ?? 0;
  const b = meters[at + 1] ?? 0;
  const c = meters[at + widthPx] ?? 0;
  const d = meters[at + widthPx + 1] ?? 0;
  const least = Math.min(a, b, c, d);
  if (!(least > 0) || Math.max(a, b, c, d) - least > GAP * least) {
    return meters[clamp(Math.floor(y), 0, heightPx - 1) * widthPx + clamp(Math.floor(x), 0, widthPx - 1)] ?? 0;
  }
  const s = x - 0.5 - column;
  const t = y - 0.5 - row;
  return 1 / ((1 - t) * ((1 - s) / a + s / b) + t * ((1 - s) / c + s / d));
}

/**
 * Of a plane n·p = h in view space, seen along (X, Y, -1): 1 / depth = (nx X + ny Y - nz) / h. The least squares of that over the window
 * give the normal.
 */
function fitNormal(out: Meeting, ray: Ray, distanceM: number, picture: DepthPicture): boolean {
  toTexel(ray, distanceM, picture);
  const column = Math.floor(scratchTexel.x);
  const row = Math.floor(scratchTexel.y);
  const { meters, widthPx, heightPx } = picture;
  const z = -(ray.oz + ray.dz * distanceM);
  const sums = scratchSums;
  sums.fill(0);
  for (let y = Math.max(0, row - WINDOW); y <= Math.min(heightPx - 1, row + WINDOW); y++) {
    for (let x = Math.max(0, column - WINDOW); x <= Math.min(widthPx - 1, column + WINDOW); x++) {
      const depth = meters[y * widthPx + x] ?? 0;
      if (!(depth > 0) || Math.abs(depth - z) > GAP * z) continue;
      toTangent(picture, (x + 0.5) / widthPx, (y + 0.5) / heightPx);
      const { x: tx, y: ty } = scratchTangent;
      const value = 1 / depth;
      add(sums, tx, ty, value);
    }
  }
  return solve(out, sums);
}

/** Sums of xx, xy, x, yy, y, 1, and of x, y and 1 times the value. */
const scratchSums = new Float64Array(9);
const scratchTangent = { x: 0, y: 0 };

function add(sums: Float64Array, x: number, y: number, value: number): void {
  sums[0] = (sums[0] ?? 0) + x * x;
  sums[1] = (sums[1] ?? 0) + x * y;
  sums[2] = (sums[2] ?? 0) + x;
  sums[3] = (sums[3] ?? 0) + y * y;
  sums[4] = (sums[4] ?? 0) + y;
  sums[5] = (sums[5] ?? 0) + 1;
  sums[6] = (sums[6] ?? 0) + x * value;
  sums[7] = (sums[7] ?? 0) + y * value;
  sums[8] = (sums[8] ?? 0) + value;
}

/** Solves the normal equations by Cramer's rule. Returns false if the samples do not determine a plane. */
function solve(out: Meeting, s: Float64Array): boolean {
  const [xx = 0, xy = 0, x = 0, yy = 0, y = 0, n = 0, xv = 0, yv = 0, v = 0] = s;
  if (n < 3) return false;
  const determinant = xx * (yy * n - y * y) - xy * (xy * n - y * x) + x * (xy * y - yy * x);
  if (Math.abs(determinant) < 1e-18) return false;
  const a = (xv * (yy * n - y * y) - xy * (yv * n - y * v) + x * (yv * y - yy * v)) / determinant;
  const b = (xx * (yv * n - y * v) - xv * (xy * n - y * x) + x * (xy * v - yv * x)) / determinant;
  const c = (xx * (yy * v - yv * y) - xy * (xy * v - yv * x) + xv * (xy * y - yy * x)) / determinant;
  out.nx = a;
  out.ny = b;
  out.nz = -c;
  return Math.hypot(a, b, c) > 0;
}

/** The direction (x, y, -1) of view space that a UV of the texture shows. */
function toTangent({ uvFromViewUv: m, clipFromView: c }: DepthPicture, u: number, v: number): void {
  // Solves the two linear equations of the homogeneous 3×3 for the view's UV.
  const a = (m[0] ?? 0) - u * (m[2] ?? 0);
  const b = (m[3] ?? 0) - u * (m[5] ?? 0);
  const e = u * (m[8] ?? 1) - (m[6] ?? 0);
  const d = (m[1] ?? 0) - v * (m[2] ?? 0);
  const f = (m[4] ?? 0) - v * (m[5] ?? 0);
  const g = v * (m[8] ?? 1) - (m[7] ?? 0);
  const determinant = a * f - b * d;
  const viewU = (e * f - b * g) / determinant;
  const viewV = (a * g - e * d) / determinant;
  scratchTangent.x = (2 * viewU - 1 + (c[8] ?? 0)) / (c[0] ?? 1);
  scratchTangent.y = (2 * viewV - 1 + (c[9] ?? 0)) / (c[5] ?? 1);
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
