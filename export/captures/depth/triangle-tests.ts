import { type DepthMap, isKnown } from './depth-map.ts';
import type { DepthRays } from './depth-rays.ts';

/**
 * Below this cosine between the normal of a triangle and the direction to the camera, the triangle may join a near thing with what is behind
 * it (the orthogonality test of Pajarola et al., “DMesh: Fast depth-image meshing and warping”, 2004).
 */
const LEAST_COSINE = 0.1;
/** And if an edge is longer per pixel than this share of its distance, it does (the size test). */
const MOST_STEP = 0.03;

/** What the builder of a depth mesh asks about pixels. A corner is a pixel as `row * widthPx + column`. */
export interface TriangleTests {
  /** Whether the depth of a pixel is known. */
  isKnown(corner: number): boolean;
  /**
   * Whether a triangle shows all pixels of a part of a block with a relative error of at most `tolerance`.
   *
   * @param isPart Whether a pixel belongs to the triangle.
   */
  fits(a: number, b: number, c: number, block: Block, isPart: (column: number, row: number) => boolean): boolean;
  /** Whether a triangle stretches over an edge of what is seen. */
  isTorn(a: number, b: number, c: number): boolean;
}

/** Pixels from the first to the last, which are both in the block. The last column may be beyond the map, where it wraps. */
export interface Block {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Creates the tests for one depth map. They allocate nothing per triangle. */
export function createTriangleTests({ values }: DepthMap, rays: DepthRays, tolerance: number): TriangleTests {
  const { widthPx, across, ahead, level, down } = rays;
  const plane = new Float64Array(3);
  const points = new Float64Array(9);

  const direct = (corner: number, at: number, factor: number): void => {
    const column = corner % widthPx;
    const row = (corner - column) / widthPx;
    points[at] = (across[column] ?? 0) * (level[row] ?? 0) * factor;
    points[at + 1] = (down[row] ?? 0) * factor;
    points[at + 2] = (ahead[column] ?? 0) * (level[row] ?? 0) * factor;
  };
  const pixelsBetween = (a: number, b: number): number => {
    const columns = Math.abs((a % widthPx) - (b % widthPx));
    const rows = Math.abs(Math.floor(a / widthPx) - Math.floor(b / widthPx));
    return Math.max(1, rays.wraps ? Math.min(columns, widthPx - columns) : columns, rows);
  };
  return {
    isKnown: (corner) => isKnown(values[corner] ?? 0),
    fits: (a, b, c, { left, top, right, bottom }, isPart) => {
      direct(a, 0, 1);
      direct(b, 3, 1);
      direct(c, 6, 1);
      // Along a ray of direction d, the plane n · point = 1 is at the depth 1 / (n · d).
      if (!solve(points, 1 / (values[a] ?? 0), 1 / (values[b] ?? 0), 1 / (values[c] ?? 0), plane)) return false;
      const [nx = 0, ny = 0, nz = 0] = plane;
      for (let row = top; row <= bottom; row++) {
        const flat = level[row] ?? 0;
        const y = ny * (down[row] ?? 0);
        for (let column = left; column <= right; column++) {
          if (!isPart(column, row)) continue;
          const wrapped = column % widthPx;
          const inverse = (nx * (across[wrapped] ?? 0) + nz * (ahead[wrapped] ?? 0)) * flat + y;
          const error = Math.abs((values[row * widthPx + wrapped] ?? 0) * inverse - 1);
          if (!(error <= tolerance)) return false;
        }
      }
      return true;
    },
    isTorn: (a, b, c) => {
      direct(a, 0, values[a] ?? 0);
      direct(b, 3, values[b] ?? 0);
      direct(c, 6, values[c] ?? 0);
      if (cosineToCamera(points) >= LEAST_COSINE) return false;
      return (
        stretch(points, 0, 3, pixelsBetween(a, b)) > MOST_STEP ||
        stretch(points, 3, 6, pixelsBetween(b, c)) > MOST_STEP ||
        stretch(points, 6, 0, pixelsBetween(c, a)) > MOST_STEP
      );
    },
  };
}

/** Solves n · dᵢ = vᵢ for the three directions in `d`. Returns false if they lie in a plane. */
function solve(d: Float64Array, v0: number, v1: number, v2: number, out: Float64Array): boolean {
  const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = d;
  const [bcx, bcy, bcz] = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
  const determinant = ax * bcx + ay * bcy + az * bcz;
  if (Math.abs(determinant) < 1e-14) return false;
  const [cax, cay, caz] = [cy * az - cz * ay, cz * ax - cx * az, cx * ay - cy * ax];
  const [abx, aby, abz] = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
  out[0] = (v0 * bcx + v1 * cax + v2 * abx) / determinant;
  out[1] = (v0 * bcy + v1 * cay + v2 * aby) / determinant;
  out[2] = (v0 * bcz + v1 * caz + v2 * abz) / determinant;
  return true;
}

/** The cosine between the normal of a triangle and the direction from its center to the camera, at the origin. */
function cosineToCamera(p: Float64Array): number {
  const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = p;
  const [ux, uy, uz] = [bx - ax, by - ay, bz - az];
  const [vx, vy, vz] = [cx - ax, cy - ay, cz - az];
  const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const [mx, my, mz] = [ax + bx + cx, ay + by + cy, az + bz + cz];
  return Math.abs(nx * mx + ny * my + nz * mz) / (Math.hypot(nx, ny, nz) * Math.hypot(mx, my, mz) || 1);
}

function stretch(p: Float64Array, from: number, to: number, pixels: number): number {
  let length = 0;
  let distance = 0;
  for (let axis = 0; axis < 3; axis++) {
    const [a, b] = [p[from + axis] ?? 0, p[to + axis] ?? 0];
    length += (b - a) * (b - a);
    distance += ((a + b) / 2) ** 2;
  }
  return Math.sqrt(length / distance) / pixels;
}
