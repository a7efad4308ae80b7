import type { Ray } from '../../kit/hit-test.ts';

/**
 * A tree of bounding boxes around triangles, in which a ray finds the first triangle without testing all. It is built once per geometry, by
 * splitting at the median along the longest axis. It consists of flat arrays, so that casting allocates nothing and a page needs only 1 kB
 * of code for it (three-mesh-bvh, with which the tests compare it: 15 kB).
 */
export interface TriangleTree {
  /** The boxes: six numbers per box, least x, y, z, greatest x, y, z. The first child of a box follows it. */
  readonly bounds: Float32Array;
  /** For an inner box, the index of its second child. For a leaf, the complement (`~`) of the index of its first triangle. */
  readonly links: Int32Array;
  /** The number of triangles of a leaf; 0 for an inner box. */
  readonly counts: Uint8Array;
  /** The vertex positions of the triangles: nine numbers per triangle, in the order of the leaves. */
  readonly corners: Float32Array;
  /** For each triangle of the tree, its index in the array that the tree was built from. */
  readonly order: Uint32Array;
}

/** The first triangle that a ray meets. */
export interface TriangleHit {
  /** Distance along the ray, as a multiple of the length of its direction. */
  along: number;
  /** Normal of the triangle, towards its front, of any length. */
  nx: number;
  ny: number;
  nz: number;
}

/** Which sides of triangles a ray meets: 1 the front (counterclockwise), -1 the back, 0 both. */
export type Sides = 1 | -1 | 0;

const LEAF = 8;
/** Size of the stack of boxes; no tree can be deeper, even one of 2³² triangles. */
const DEPTH = 64;
/** Tolerance of barycentric coordinates, so that a ray through a shared edge meets at least one of the two triangles. */
const SLACK = 1e-9;
/** Replaces 0 in ray directions, so that the distances to the planes of a box are finite. */
const TINY = 1e-30;

/**
 * Builds the tree of triangles.
 *
 * @param corners Nine numbers per triangle. Triangles with a number that is not finite are left out.
 */
export function buildTriangleTree(corners: Float32Array): TriangleTree {
  const order = finiteTriangles(corners);
  const count = order.length;
  const centers = centersOf(corners);
  const most = Math.max(1, Math.ceil((4 * count) / LEAF) + 1);
  const bounds = new Float32Array(6 * most);
  const links = new Int32Array(most);
  const counts = new Uint8Array(most);
  let made = 0;

  function addBox(from: number, to: number): void {
    const box = made++;
    writeBounds(bounds, box, corners, order, from, to);
    if (to - from <= LEAF) {
      links[box] = ~from;
      counts[box] = to - from;
      return;
    }
    const middle = (from + to) >> 1;
    selectMiddle(order, centers, longestAxis(centers, order, from, to), from, to, middle);
    addBox(from, middle);
    links[box] = made;
    addBox(middle, to);
  }
  addBox(0, count);

  const sorted = new Float32Array(9 * count);
  for (let i = 0; i < count; i++) {
    const at = 9 * (order[i] ?? 0);
    sorted.set(corners.subarray(at, at + 9), 9 * i);
  }
  return { bounds: bounds.slice(0, 6 * made), links: links.slice(0, made), counts: counts.slice(0, made), corners: sorted, order };
}

function finiteTriangles(corners: Float32Array): Uint32Array {
  const all = new Uint32Array(Math.floor(corners.length / 9));
  let kept = 0;
  for (let t = 0; t < all.length; t++) {
    let sum = 0;
    for (let i = 0; i < 9; i++) sum += corners[9 * t + i] ?? 0;
    if (Number.isFinite(sum)) all[kept++] = t;
  }
  return all.slice(0, kept);
}

function centersOf(corners: Float32Array): Float32Array {
  const centers = new Float32Array(corners.length / 3);
  for (let i = 0; i < centers.length; i++) {
    const at = 9 * Math.floor(i / 3) + (i % 3);
    centers[i] = ((corners[at] ?? 0) + (corners[at + 3] ?? 0) + (corners[at + 6] ?? 0)) / 3;
  }
  return centers;
}

function writeBounds(bounds: Float32Array, box: number, corners: Float32Array, order: Uint32Array, from: number, to: number): void {
  for (let axis = 0; axis < 3; axis++) {
    let least = Number.POSITIVE_INFINITY;
    let greatest = Number.NEGATIVE_INFINITY;
    for (let i = from; i < to; i++) {
      const at = 9 * (order[i] ?? 0) + axis;
      for (let corner = 0; corner < 9; corner += 3) {
        const value = corners[at + corner] ?? 0;
        least = Math.min(least, value);
        greatest = Math.max(greatest, value);
      }
    }
    bounds[6 * box + axis] = least;
    bounds[6 * box + 3 + axis] = greatest;
  }
}

function longestAxis(centers: Float32Array, order: Uint32Array, from: number, to: number): number {
  let longest = 0;
  let length = -1;
  for (let axis = 0; axis < 3; axis++) {
    let least = Number.POSITIVE_INFINITY;
    let greatest = Number.NEGATIVE_INFINITY;
    for (let i = from; i < to; i++) {
      const value = centers[3 * (order[i] ?? 0) + axis] ?? 0;
      least = Math.min(least, value);
      greatest = Math.max(greatest, value);
    }
    if (greatest - least > length) {
      length = greatest - least;
      longest = axis;
    }
  }
  return longest;
}

/** Orders triangles so that those before `middle` come first along the axis (by repeated partition, with the middle one as pivot). */
function selectMiddle(order: Uint32Array, centers: Float32Array, axis: number, from: number, to: number, middle: number): void {
  const valueAt = (i: number): number => centers[3 * (order[i] ?? 0) + axis] ?? 0;
  let low = from;
  let high = to - 1;
  while (low < high) {
    const pivot = valueAt((low + high) >> 1);
    let i = low;
    let j = high;
    while (i <= j) {
      while (valueAt(i) < pivot) i++;
      while (valueAt(j) > pivot) j--;
      if (i > j) break;
      const swapped = order[i] ?? 0;
      order[i++] = order[j] ?? 0;
      order[j--] = swapped;
    }
    if (middle <= j) high = j;
    else if (middle >= i) low = i;
    else return;
  }
}

// Filled and read within one call.
const scratchStack = new Int32Array(DEPTH);

/**
 * Finds the first triangle that a ray meets.
 *
 * @param out On input, its `along` is the greatest distance that counts. Unchanged if no triangle is met.
 * @returns Whether a triangle is met.
 */
export function castAtTree(out: TriangleHit, { bounds, links, counts, corners }: TriangleTree, ray: Ray, sides: Sides): boolean {
  let found = false;
  let top = 0;
  let box = 0;
  if (corners.length === 0) return false;
  if (!(entryOf(bounds, 0, ray, out.along) < Number.POSITIVE_INFINITY)) return false;
  for (;;) {
    const count = counts[box] ?? 0;
    const link = links[box] ?? 0;
    if (count > 0) {
      for (let t = ~link; t < ~link + count; t++) found = castAtTriangle(out, corners, 9 * t, ray, sides) || found;
    } else {
      const first = entryOf(bounds, box + 1, ray, out.along);
      const second = entryOf(bounds, link, ray, out.along);
      if (first < Number.POSITIVE_INFINITY || second < Number.POSITIVE_INFINITY) {
        const isFirstNearer = first <= second;
        if (Math.max(first, second) < Number.POSITIVE_INFINITY) scratchStack[top++] = isFirstNearer ? link : box + 1;
        box = isFirstNearer ? box + 1 : link;
        continue;
      }
    }
    // What was put aside may be farther than what has been met since.
    do {
      if (top === 0) return found;
      box = scratchStack[--top] ?? 0;
    } while (!(entryOf(bounds, box, ray, out.along) < Number.POSITIVE_INFINITY));
  }
}

/** The distance along a ray at which it enters a box, or infinity if it does not enter the box before `limit`. */
export function entryOf(bounds: ArrayLike<number>, box: number, { ox, oy, oz, dx, dy, dz }: Ray, limit: number): number {
  const at = 6 * box;
  const ix = 1 / (dx || TINY);
  const iy = 1 / (dy || TINY);
  const iz = 1 / (dz || TINY);
  const x0 = ((bounds[at] ?? 0) - ox) * ix;
  const x1 = ((bounds[at + 3] ?? 0) - ox) * ix;
  const y0 = ((bounds[at + 1] ?? 0) - oy) * iy;
  const y1 = ((bounds[at + 4] ?? 0) - oy) * iy;
  const z0 = ((bounds[at + 2] ?? 0) - oz) * iz;
  const z1 = ((bounds[at + 5] ?? 0) - oz) * iz;
  const enter = Math.max(Math.min(x0, x1), Math.min(y0, y1), Math.min(z0, z1), 0);
  const leave = Math.min(Math.max(x0, x1), Math.max(y0, y1), Math.max(z0, z1), limit);
  // A hair of slack, because a flat box is entered and left at once.
  return enter <= leave + 1e-12 * Math.abs(leave) ? enter : Number.POSITIVE_INFINITY;
}

/**
 * Intersects a ray with one triangle (Möller and Trumbore 1997); the sign of the determinant tells front from back. `at` is the index of
 * the triangle's first number in `c`.
 */
export function castAtTriangle(out: TriangleHit, c: ArrayLike<number>, at: number, { ox, oy, oz, dx, dy, dz }: Ray, sides: Sides): boolean {
  const ax = c[at] ?? 0;
  const ay = c[at + 1] ?? 0;
  const az = c[at + 2] ?? 0;
  const ux = (c[at + 3] ?? 0) - ax;
  const uy = (c[at + 4] ?? 0) - ay;
  const uz = (c[at + 5] ?? 0) - az;
  const vx = (c[at + 6] ?? 0) - ax;
  const vy = (c[at + 7] ?? 0) - ay;
  const vz = (c[at + 8] ?? 0) - az;
  const px = dy * vz - dz * vy;
  const py = dz * vx - dx * vz;
  const pz = dx * vy - dy * vx;
  const determinant = ux * px + uy * py + uz * pz;
  if (determinant === 0 || determinant * sides < 0) return false;
  const tx = ox - ax;
  const ty = oy - ay;
  const tz = oz - az;
  const u = (tx * px + ty * py + tz * pz) / determinant;
  if (!(u >= -SLACK && u <= 1 + SLACK)) return false;
  const qx = ty * uz - tz * uy;
  const qy = tz * ux - tx * uz;
  const qz = tx * uy - ty * ux;
  const v = (dx * qx + dy * qy + dz * qz) / determinant;
  if (!(v >= -SLACK && u + v <= 1 + SLACK)) return false;
  const along = (vx * qx + vy * qy + vz * qz) / determinant;
  if (!(along >= 0 && along < out.along)) return false;
  out.along = along;
  out.nx = uy * vz - uz * vy;
  out.ny = uz * vx - ux * vz;
  out.nz = ux * vy - uy * vx;
  return true;
}
