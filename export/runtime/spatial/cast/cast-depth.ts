import type { Ray } from '../../../../nodes/kit/hit-test.ts';
import { createRay, type Meeting, toLocal, turnNormal } from '../ray.ts';
import { type FittedSurface, fitSurface } from './fit-surface.ts';

/** An image of room depth on the CPU, with the view for which it was measured. */
export interface DepthImage {
  /** Depth along the view's axis, meters, 0 where unknown; rows as in the texture. */
  meters: Float32Array;
  widthPx: number;
  heightPx: number;
  /** Matrix from view UV to texture UV, column-major 3×3, homogeneous. */
  readonly uvFromViewUv: Float32Array;
  readonly clipFromView: Float32Array;
  readonly worldFromView: Float32Array;
  /** Index of the frame in which the depth was measured. */
  frame: number;
}

/** The range in which a ray is followed, meters along the view's axis. */
const NEAR_M = 0.05;
const FAR_M = 20;
/** Maximum number of samples along a ray. */
const MAX_STEPS = 512;
/** Neighboring samples that differ by more than this fraction of their distance belong to two surfaces. */
const GAP = 0.1;
/** Maximum distance by which a hit is moved to the fitted plane, in standard deviations of a sample. */
const MOVES = 5;

// Filled and read within one call.
const scratchRay = createRay();
const scratchTexel = { x: 0, y: 0 };
const scratchSurface: FittedSurface = { a: 0, b: 0, c: 0, sigma: 0 };
/** The image whose UV `toTangent` converts. */
let tangentOf: DepthImage | null = null;

/**
 * Follows a ray through a depth image until it goes behind a surface. A ray that passes behind an edge, where depth jumps, continues,
 * because the space there is unknown. Between samples, 1 / depth is interpolated, which is exact for planes. The hit is then moved to the
 * plane that fits the surrounding samples best (`fitSurface`), which has less noise than one sample and gives the normal.
 *
 * @returns False if the ray meets nothing; `out` is then unchanged.
 */
export function castAtDepth(out: Meeting, ray: Ray, image: DepthImage): boolean {
  toLocal(scratchRay, ray, image.worldFromView);
  const view = scratchRay;
  const [near, far] = clipToView(view, image);
  if (!(far > near)) return false;
  const zNear = -(view.oz + view.dz * near);
  const zFar = -(view.oz + view.dz * far);
  const steps = Math.min(MAX_STEPS, Math.max(1, Math.ceil(pixelsBetween(view, near, far, image) * 2)));
  let before = 0;
  let wasInFront = behind(view, near, image) < 0;
  for (let i = 1; i <= steps; i++) {
    const s = i / steps;
    const gap = behind(view, distanceAt(s, near, far, zNear, zFar), image);
    if (Number.isNaN(gap)) {
      wasInFront = false;
      continue;
    }
    if (gap >= 0 && wasInFront) {
      let low = before;
      let high = s;
      for (let k = 0; k < 40; k++) {
        const middle = (low + high) / 2;
        if (behind(view, distanceAt(middle, near, far, zNear, zFar), image) < 0) low = middle;
        else high = middle;
      }
      const distanceM = distanceAt(high, near, far, zNear, zFar);
      const z = -(view.oz + view.dz * distanceM);
      if (Math.abs(behind(view, distanceM, image)) <= 0.001 * z && meetSurface(out, view, distanceM, z, image)) {
        turnNormal(out, image.worldFromView);
        return true;
      }
    }
    wasInFront = gap < 0;
    before = s;
  }
  return false;
}

/** The distance along the ray at a fraction `s` of its way on the screen. Equal steps on the screen are equal steps in 1 / depth. */
function distanceAt(s: number, near: number, far: number, zNear: number, zFar: number): number {
  const a = (1 - s) / zNear;
  const b = s / zFar;
  return (near * a + far * b) / (a + b);
}

/** The part of a ray that the view sees, as distances along it. Filled and read within one call. */
const scratchRange: [near: number, far: number] = [0, 0];

function clipToView(ray: Ray, { clipFromView: c }: DepthImage): readonly [number, number] {
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

/** Limits the range of the ray to the half space a x + b y + d z + w >= 0. */
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

function pixelsBetween(ray: Ray, near: number, far: number, image: DepthImage): number {
  toTexel(ray, near, image);
  const { x, y } = scratchTexel;
  toTexel(ray, far, image);
  return Math.hypot(scratchTexel.x - x, scratchTexel.y - y);
}

/** Projects a point of the ray to the image, in samples, whose centers are at halves. */
function toTexel(
  { ox, oy, oz, dx, dy, dz }: Ray,
  distanceM: number,
  { clipFromView: c, uvFromViewUv: m, widthPx, heightPx }: DepthImage,
): void {
  const z = -(oz + dz * distanceM);
  const u = (((c[0] ?? 1) * (ox + dx * distanceM)) / z - (c[8] ?? 0) + 1) / 2;
  const v = (((c[5] ?? 1) * (oy + dy * distanceM)) / z - (c[9] ?? 0) + 1) / 2;
  const w = (m[2] ?? 0) * u + (m[5] ?? 0) * v + (m[8] ?? 1);
  scratchTexel.x = (((m[0] ?? 0) * u + (m[3] ?? 0) * v + (m[6] ?? 0)) / w) * widthPx;
  scratchTexel.y = (((m[1] ?? 0) * u + (m[4] ?? 0) * v + (m[7] ?? 0)) / w) * heightPx;
}

/**
 * How far a point of the ray is behind the surface in the image, along the view's axis, meters; negative in front of it, NaN where depth is
 * unknown.
 */
function behind(ray: Ray, distanceM: number, image: DepthImage): number {
  toTexel(ray, distanceM, image);
  const depth = sample(image, scratchTexel.x, scratchTexel.y);
  return depth > 0 ? -(ray.oz + ray.dz * distanceM) - depth : Number.NaN;
}

function sample({ meters, widthPx, heightPx }: DepthImage, x: number, y: number): number {
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
    const nearest = meters[clamp(Math.floor(y), 0, heightPx - 1) * widthPx + clamp(Math.floor(x), 0, widthPx - 1)] ?? 0;
    return nearest > 0 ? nearest : aroundHole(a, b, c, d);
  }
  const s = x - 0.5 - column;
  const t = y - 0.5 - row;
  return 1 / ((1 - t) * ((1 - s) / a + s / b) + t * ((1 - s) / c + s / d));
}

/** Depth at a sample without a value: the harmonic mean of its known neighbors if they belong to one surface, else 0. */
function aroundHole(...depths: [number, number, number, number]): number {
  let count = 0;
  let inverse = 0;
  let least = Number.POSITIVE_INFINITY;
  let most = 0;
  for (let i = 0; i < 4; i++) {
    const depth = depths[i] ?? 0;
    if (!(depth > 0)) continue;
    count++;
    inverse += 1 / depth;
    least = Math.min(least, depth);
    most = Math.max(most, depth);
  }
  return count >= 2 && most - least <= GAP * least ? count / inverse : 0;
}

/**
 * Writes a hit to `out`: fits a plane around it, moves it along the ray to that plane, and sets its normal in view space. Returns false if
 * no plane fits.
 */
function meetSurface(out: Meeting, ray: Ray, distanceM: number, z: number, image: DepthImage): boolean {
  toTexel(ray, distanceM, image);
  tangentOf = image;
  const isFitted = fitSurface(scratchSurface, image, Math.floor(scratchTexel.x), Math.floor(scratchTexel.y), z, toTangent);
  tangentOf = null;
  if (!isFitted) return false;
  const { a, b, c, sigma } = scratchSurface;
  out.nx = a;
  out.ny = b;
  out.nz = -c;
  // n·(o + t d) = 1. A plane that the ray meets elsewhere is not the surface of the sample.
  const along = (1 - (a * ray.ox + b * ray.oy - c * ray.oz)) / (a * ray.dx + b * ray.dy - c * ray.dz);
  out.distanceM = Math.abs(along - distanceM) <= MOVES * sigma * distanceM ? along : distanceM;
  return true;
}

/** Sets `x` and `y` of the direction (x, y, -1) in view space that is seen at a UV of the texture. */
function toTangent(u: number, v: number, out: { x: number; y: number }): void {
  if (!tangentOf) return;
  const { uvFromViewUv: m, clipFromView: c } = tangentOf;
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
  out.x = (2 * viewU - 1 + (c[8] ?? 0)) / (c[0] ?? 1);
  out.y = (2 * viewV - 1 + (c[9] ?? 0)) / (c[5] ?? 1);
}

function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}
