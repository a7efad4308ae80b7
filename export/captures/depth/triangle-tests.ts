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
   * Whether a triangle shows all its pixels, including those on its edges, with a relative error of at most `tolerance`. Corners are columns
   * and rows, clockwise; a column may be beyond the map where it wraps.
   */
  fits(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): boolean;
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

  const wrapped = (column: number): number => (column < 0 ? column + widthPx : column < widthPx ? column : column - widthPx);
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
    fits: (ax, ay, bx, by, cx, cy) => {
      const a = ay * widthPx + wrapped(ax);
      const b = by * widthPx + wrapped(bx);
      const c = cy * widthPx + wrapped(cx);
      direct(a, 0, 1);
      direct(b, 3, 1);
      direct(c, 6, 1);
      // Along a ray of direction d, the plane n · point = 1 is at the depth 1 / (n · d).
      if (!solve(points, 1 / (values[a] ?? 0), 1 / (values[b] ?? 0), 1 / (values[c] ?? 0), plane)) return false;
      const [nx, ny, nz] = [plane[0] ?? 0, plane[1] ?? 0, plane[2] ?? 0];
      const leastColumn = Math.min(ax, bx, cx);
      const mostColumn = Math.max(ax, bx, cx);
      const bottom = Math.max(ay, by, cy);
      for (let row = Math.min(ay, by, cy); row <= bottom; row++) {
        const flat = level[row] ?? 0;
        const y = ny * (down[row] ?? 0);
        // The columns of the row that are inside of each edge.
        const left =
          Math.max(leastColumn, firstInside(ax, ay, bx, by, row), firstInside(bx, by, cx, cy, row), firstInside(cx, cy, ax, ay, row)) | 0;
        const right =
          Math.min(mostColumn, lastInside(ax, ay, bx, by, row), lastInside(bx, by, cx, cy, row), lastInside(cx, cy, ax, ay, row)) | 0;
        for (let column = left; column <= right; column++) {
          const at = wrapped(column);
          const inverse = (nx * (across[at] ?? 0) + nz * (ahead[at] ?? 0)) * flat + y;
          const error = Math.abs((values[row * widthPx + at] ?? 0) * inverse - 1);
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

/** The first column of a row inside of an edge that goes up on the left of a triangle. */
function firstInside(ax: number, ay: number, bx: number, by: number, row: number): number {
  return by < ay ? ax + Math.ceil(((bx - ax) * (row - ay)) / (by - ay)) : Number.NEGATIVE_INFINITY;
}

/** The last column of a row inside of an edge that goes down on the right of a triangle. */
function lastInside(ax: number, ay: number, bx: number, by: number, row: number): number {
  return by > ay ? ax + Math.floor(((bx - ax) * (row - ay)) / (by - ay)) : Number.POSITIVE_INFINITY;
}

/** Solves n · dᵢ = vᵢ for the three directions in `d`. Returns false if they lie in a plane. */
function solve(d: Float64Array, v0: number, v1: number, v2: number, out: Float64Array): boolean {
  const at = (i: number): number => d[i] ?? 0;
  const bcx = at(4) * at(8) - at(5) * at(7);
  const bcy = at(5) * at(6) - at(3) * at(8);
  const bcz = at(3) * at(7) - at(4) * at(6);
  const determinant = at(0) * bcx + at(1) * bcy + at(2) * bcz;
  if (Math.abs(determinant) < 1e-14) return false;
  out[0] = (v0 * bcx + v1 * (at(7) * at(2) - at(8) * at(1)) + v2 * (at(1) * at(5) - at(2) * at(4))) / determinant;
  out[1] = (v0 * bcy + v1 * (at(8) * at(0) - at(6) * at(2)) + v2 * (at(2) * at(3) - at(0) * at(5))) / determinant;
  out[2] = (v0 * bcz + v1 * (at(6) * at(1) - at(7) * at(0)) + v2 * (at(0) * at(4) - at(1) * at(3))) / determinant;
  return true;
}

/** The cosine between the normal of a triangle and the direction from its center to the camera, at the origin. */
function cosineToCamera(p: Float64Array): number {
  const at = (i: number): number => p[i] ?? 0;
  const along = (from: number, axis: number): number => at(from + axis) - at(axis);
  const nx = along(3, 1) * along(6, 2) - along(3, 2) * along(6, 1);
  const ny = along(3, 2) * along(6, 0) - along(3, 0) * along(6, 2);
  const nz = along(3, 0) * along(6, 1) - along(3, 1) * along(6, 0);
  const mx = at(0) + at(3) + at(6);
  const my = at(1) + at(4) + at(7);
  const mz = at(2) + at(5) + at(8);
  return Math.abs(nx * mx + ny * my + nz * mz) / (Math.sqrt((nx * nx + ny * ny + nz * nz) * (mx * mx + my * my + mz * mz)) || 1);
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
