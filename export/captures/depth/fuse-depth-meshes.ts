import type { CaptureMesh, Pinhole } from '../../../nodes/kit/capture.ts';
import { depthSeen } from './depth-from-mesh.ts';
import type { DepthMap } from './depth-map.ts';
import type { DepthMesh } from './depth-mesh.ts';
import { pointsOfDepthMesh } from './depth-points.ts';
import { raysOf } from './depth-rays.ts';

/** Distance from a surface, relative to depth, within which two views show the same one: each of their meshes may be off by half of it. */
const SAME_SURFACE = 0.01;
/** Depth along the ray is compared: at surfaces that it grazes, it changes by more than the distance, but by at most 1 over this. */
const LEAST_COSINE = 0.1;

/** The depth mesh of a view with the map that it was made from and the camera of both. Lengths in the same unit. */
export interface FusedView {
  readonly made: DepthMesh;
  readonly map: DepthMap;
  readonly camera: Pinhole;
  /** Column-major 4×4; the camera looks along −z. */
  readonly worldFromCamera: readonly number[];
}

/** Joins the depth meshes of views, one after the other, into the mesh of a place. */
export interface DepthFusion {
  add(view: FusedView): void;
  /** The mesh so far, in world space. */
  mesh(): CaptureMesh;
}

/**
 * Joins depth meshes without most of what several views show: of each view, triangles are left out where the views before it have the same
 * surface in every pixel of the triangle. So edges of what is kept overlap by less than a triangle, and there are no gaps. Without this,
 * a place that n views show would be drawn n times.
 */
export function createDepthFusion(): DepthFusion {
  const positions: number[] = [];
  const indices: number[] = [];
  const mesh = (): CaptureMesh => ({ positions: Float32Array.from(positions), indices: Uint32Array.from(indices) });
  return {
    mesh,
    add: (view) => {
      const { made, camera, worldFromCamera: m } = view;
      const before = indices.length === 0 ? null : depthSeen(mesh(), camera, m);
      const points = pointsOfDepthMesh(made, raysOf(camera)).positions;
      const numbers = new Map<number, number>();
      const numberOf = (vertex: number): number => {
        const known = numbers.get(vertex);
        if (known !== undefined) return known;
        const number = positions.length / 3;
        numbers.set(vertex, number);
        const [x = 0, y = 0, z = 0] = points.subarray(3 * vertex, 3 * vertex + 3);
        for (let row = 0; row < 3; row++) {
          positions.push(x * (m[row] ?? 0) + y * (m[4 + row] ?? 0) + z * (m[8 + row] ?? 0) + (m[12 + row] ?? 0));
        }
        return number;
      };
      for (let i = 0; i < made.indices.length; i += 3) {
        const corners = made.indices.subarray(i, i + 3);
        if (before && isShown(view, corners, before, SAME_SURFACE / Math.max(LEAST_COSINE, facing(points, corners)))) continue;
        for (const corner of corners) indices.push(numberOf(corner));
      }
    },
  };
}

/** The cosine between the normal of a triangle and the ray to its first corner, from the camera at the origin. */
function facing(points: Float32Array, corners: Uint32Array): number {
  const [a, b, c] = [0, 1, 2].map((i) => points.subarray(3 * (corners[i] ?? 0), 3 * (corners[i] ?? 0) + 3)) as [
    Float32Array,
    Float32Array,
    Float32Array,
  ];
  const [ax = 0, ay = 0, az = 0] = a;
  const [ux, uy, uz] = [(b[0] ?? 0) - ax, (b[1] ?? 0) - ay, (b[2] ?? 0) - az];
  const [vx, vy, vz] = [(c[0] ?? 0) - ax, (c[1] ?? 0) - ay, (c[2] ?? 0) - az];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx] as const;
  return Math.abs(normal[0] * ax + normal[1] * ay + normal[2] * az) / Math.hypot(...normal) / Math.hypot(ax, ay, az);
}

/** Whether another mesh shows the surface of a triangle in every pixel whose center the triangle contains. */
function isShown({ made: { places }, map }: FusedView, corners: Uint32Array, before: DepthMap, tolerance: number): boolean {
  const { widthPx, heightPx } = map;
  // Pixel coordinates, in which the first pixel is (0, 0).
  const [ax, bx, cx] = unwrapped([0, 1, 2].map((i) => ((places[2 * (corners[i] ?? 0)] ?? 0) - 1) / 2) as [number, number, number], widthPx);
  const [ay, by, cy] = [0, 1, 2].map((i) => ((places[2 * (corners[i] ?? 0) + 1] ?? 0) - 1) / 2) as [number, number, number];
  // Poles of 360° photographs lie between pixels.
  if (Math.min(ay, by, cy) < 0 || Math.max(ay, by, cy) > heightPx - 1) return false;
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area === 0) return false;
  for (let row = Math.min(ay, by, cy); row <= Math.max(ay, by, cy); row++) {
    for (let column = Math.min(ax, bx, cx); column <= Math.max(ax, bx, cx); column++) {
      const b = ((column - ax) * (cy - ay) - (row - ay) * (cx - ax)) / area;
      const c = ((bx - ax) * (row - ay) - (by - ay) * (column - ax)) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const at = row * widthPx + (column % widthPx);
      const depth = map.values[at] ?? 0;
      if (!(Math.abs((before.values[at] ?? 0) - depth) <= tolerance * depth)) return false;
    }
  }
  return true;
}

/** The columns of a triangle of which no two are more than half the width apart: those beyond the last column of a 360° photograph go on. */
function unwrapped(columns: readonly [number, number, number], widthPx: number): readonly [number, number, number] {
  if (Math.max(...columns) - Math.min(...columns) <= widthPx / 2) return columns;
  return columns.map((column) => (column < widthPx / 2 ? column + widthPx : column)) as [number, number, number];
}
