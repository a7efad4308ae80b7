import { CaptureError } from '../../../nodes/kit/capture.ts';
import type { SourceView } from '../source-view.ts';
import { plyHead } from '../write-ply.ts';
import { createNearestPoints } from './nearest-points.ts';

/** Points of a surface, with the directions that it faces. */
export interface SurfacePoints {
  /** x, y and z of each point, in units and axes of the reconstruction. */
  readonly positions: Float32Array;
  /** Unit normals. */
  readonly normals: Float32Array;
}

/** Neighbors that a normal is estimated from: fewer follow errors of single points, more round off corners. */
const NEIGHBORS = 20;
/** Without these many points there is no surface worth a mesh. */
const LEAST_POINTS = 50;
/** Of more points, every second, third or further one is left out: the mesh would not become finer. */
const MOST_POINTS = 200_000;
/** The box of the middle 98 % of the points along each axis, enlarged by half, has what is kept: single points far away would make all else coarse. */
const TAIL = 0.01;
const MARGIN = 0.5;
/** Steps of the power iteration. */
const STEPS = 40;

/**
 * The points that a reconstruction found, with normals for a mesher: the direction in which the neighbors of a point vary least (principal
 * components, Hoppe et al., “Surface reconstruction from unorganized points”, 1992), on the side of the cameras that saw it.
 *
 * @throws CaptureError if there are too few points.
 */
export function surfacePoints(views: readonly SourceView[]): SurfacePoints {
  const { positions, towards } = seenPoints(views);
  const kept = withoutFarPoints(positions);
  if (kept.length < LEAST_POINTS) {
    throw new CaptureError(
      `its photographs share ${kept.length} points only, too few for a surface. Take more photographs, of things with details`,
    );
  }
  const pick = (values: readonly number[]): Float32Array => Float32Array.from(kept.flatMap((i) => values.slice(3 * i, 3 * i + 3)));
  const points = pick(positions);
  const sides = pick(towards);
  const normals = new Float32Array(points.length);
  const tree = createNearestPoints(points);
  for (let i = 0; i < points.length; i += 3) {
    const near = tree.near(points[i] ?? 0, points[i + 1] ?? 0, points[i + 2] ?? 0, NEIGHBORS);
    const normal = flatDirection(points, near);
    const side = normal.reduce((sum, value, axis) => sum + value * (sides[i + axis] ?? 0), 0) < 0 ? -1 : 1;
    normals.set(
      normal.map((value) => side * value),
      i,
    );
  }
  return { positions: points, normals };
}

/** Each point once, with the sum of the directions to the cameras that saw it. */
function seenPoints(views: readonly SourceView[]) {
  const numbers = new Map<string, number>();
  const positions: number[] = [];
  const towards: number[] = [];
  for (const { observations, worldFromCamera } of views) {
    for (let i = 0; i + 4 < observations.length; i += 5) {
      const position = observations.subarray(i + 2, i + 5);
      const key = position.join();
      let number = numbers.get(key);
      if (number === undefined) {
        number = positions.length / 3;
        numbers.set(key, number);
        positions.push(...position);
        towards.push(0, 0, 0);
      }
      const away = Array.from(position, (value, axis) => (worldFromCamera[12 + axis] ?? 0) - value);
      const length = Math.hypot(...away) || 1;
      for (let axis = 0; axis < 3; axis++) {
        const place = 3 * number + axis;
        towards[place] = (towards[place] ?? 0) + (away[axis] ?? 0) / length;
      }
    }
  }
  return { positions, towards };
}

/** Indices of the points that are not far from the others, and not too many. */
function withoutFarPoints(positions: readonly number[]): readonly number[] {
  const ranges = [0, 1, 2].map((axis) => {
    const sorted = Float64Array.from(positions.filter((_, i) => i % 3 === axis)).sort();
    const [least = 0, most = 0] = [TAIL, 1 - TAIL].map((share) => sorted[Math.round(share * (sorted.length - 1))]);
    return [least - MARGIN * (most - least), most + MARGIN * (most - least)] as const;
  });
  const count = positions.length / 3;
  const stride = Math.ceil(count / MOST_POINTS);
  const kept: number[] = [];
  for (let i = 0; i < count; i += stride) {
    if (ranges.every(([least, most], axis) => (positions[3 * i + axis] ?? 0) >= least && (positions[3 * i + axis] ?? 0) <= most))
      kept.push(i);
  }
  return kept;
}

/** The unit direction in which points vary least: the eigenvector of the smallest eigenvalue of their covariance. */
function flatDirection(positions: Float32Array, points: readonly number[]): readonly number[] {
  const mean = [0, 1, 2].map((axis) => points.reduce((sum, point) => sum + (positions[3 * point + axis] ?? 0), 0) / points.length);
  const m = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (const point of points) {
    const d = mean.map((value, axis) => (positions[3 * point + axis] ?? 0) - value);
    for (let i = 0; i < 9; i++) m[i] = (m[i] ?? 0) + (d[i % 3] ?? 0) * (d[Math.floor(i / 3)] ?? 0);
  }
  // The largest eigenvalue of (trace − M) belongs to the smallest of M.
  const trace = (m[0] ?? 0) + (m[4] ?? 0) + (m[8] ?? 0);
  // A start that is hardly orthogonal to what is sought.
  let v: readonly number[] = [0.48, 0.6, 0.64];
  for (let step = 0; step < STEPS; step++) {
    const next = v.map((value, row) => trace * value - v.reduce((sum, other, column) => sum + (m[3 * row + column] ?? 0) * other, 0));
    const length = Math.hypot(...next);
    if (length === 0) break;
    v = next.map((value) => value / length);
  }
  return v;
}

/** The points as a binary PLY file with normals. */
export function pointsAsPly({ positions, normals }: SurfacePoints): Uint8Array {
  const count = positions.length / 3;
  const properties = ['x', 'y', 'z', 'nx', 'ny', 'nz'].map((name) => `property float ${name}`);
  // COLMAP’s mesher wants colors.
  const colors = ['red', 'green', 'blue'].map((name) => `property uchar ${name}`);
  const head = plyHead(count, [...properties, ...colors]);
  const bytes = new Uint8Array(head.length + POINT_BYTES * count);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      view.setFloat32(POINT_BYTES * i + 4 * axis, positions[3 * i + axis] ?? 0, true);
      view.setFloat32(POINT_BYTES * i + 12 + 4 * axis, normals[3 * i + axis] ?? 0, true);
    }
  }
  return bytes;
}

const POINT_BYTES = 27;
