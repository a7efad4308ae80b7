import type { CaptureMesh } from '../../nodes/kit/capture.ts';
import { type Lens, unproject } from './lens.ts';

type Vector = readonly [number, number, number];

/**
 * The point of the mesh that a camera sees at a place of its photograph.
 *
 * @param lens Of a photograph that is not a 360° one.
 * @param worldFromCamera Pose in the space of the mesh; the camera looks along −z.
 * @param column In pixels of the photograph, from its left edge; `row` from the top.
 * @returns Null if there is no mesh.
 */
export function pickPoint(mesh: CaptureMesh, lens: Lens, worldFromCamera: readonly number[], column: number, row: number): Vector | null {
  const place = new Float64Array(2);
  unproject(lens, column, row, place);
  const [x = Number.NaN, y = Number.NaN] = place;
  if (!Number.isFinite(x + y)) return null;
  const m = (i: number): number => worldFromCamera[i] ?? 0;
  const along = (axis: number): number => x * m(axis) - y * m(4 + axis) - m(8 + axis);
  const eye: Vector = [m(12), m(13), m(14)];
  const ray: Vector = [along(0), along(1), along(2)];
  const distance = nearestHit(mesh, eye, ray);
  return Number.isFinite(distance) ? [eye[0] + distance * ray[0], eye[1] + distance * ray[1], eye[2] + distance * ray[2]] : null;
}

/** The multiple of the ray at the nearest triangle (Möller and Trumbore 1997, from both sides); infinite without one. */
function nearestHit({ positions, indices }: CaptureMesh, eye: Vector, ray: Vector): number {
  let nearest = Number.POSITIVE_INFINITY;
  const at = (corner: number, axis: number): number => positions[3 * (indices[corner] ?? 0) + axis] ?? 0;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const [ax, ay, az] = [at(i, 0), at(i, 1), at(i, 2)];
    const [ux, uy, uz] = [at(i + 1, 0) - ax, at(i + 1, 1) - ay, at(i + 1, 2) - az];
    const [vx, vy, vz] = [at(i + 2, 0) - ax, at(i + 2, 1) - ay, at(i + 2, 2) - az];
    const [px, py, pz] = [ray[1] * vz - ray[2] * vy, ray[2] * vx - ray[0] * vz, ray[0] * vy - ray[1] * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) continue;
    const [tx, ty, tz] = [eye[0] - ax, eye[1] - ay, eye[2] - az];
    const u = (tx * px + ty * py + tz * pz) / determinant;
    if (u < 0 || u > 1) continue;
    const [qx, qy, qz] = [ty * uz - tz * uy, tz * ux - tx * uz, tx * uy - ty * ux];
    const v = (ray[0] * qx + ray[1] * qy + ray[2] * qz) / determinant;
    if (v < 0 || u + v > 1) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / determinant;
    if (distance > 0 && distance < nearest) nearest = distance;
  }
  return nearest;
}
