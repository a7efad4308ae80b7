import type { Ray, RayMeeting } from '../../../nodes/kit/hit-test.ts';

export type Meeting = RayMeeting;

/** Creates a ray, whose direction always has the length 1. */
export function createRay(): Ray {
  return { ox: 0, oy: 0, oz: 0, dx: 0, dy: 0, dz: -1 };
}

export function createMeeting(): Meeting {
  return { distanceM: 0, nx: 0, ny: 1, nz: 0 };
}

/** Sets a ray from a rigid column-major 4×4 matrix: from its origin along its -z axis. Returns false if a number is not finite. */
export function setRay(ray: Ray, worldFromRay: ArrayLike<number>): boolean {
  const at = (i: number): number => worldFromRay[i] ?? Number.NaN;
  const length = Math.hypot(at(8), at(9), at(10));
  ray.ox = at(12);
  ray.oy = at(13);
  ray.oz = at(14);
  ray.dx = -at(8) / length;
  ray.dy = -at(9) / length;
  ray.dz = -at(10) / length;
  return Number.isFinite(ray.ox + ray.oy + ray.oz + ray.dx + ray.dy + ray.dz);
}

/** Transforms a ray to the local space of a rigid column-major 4×4 matrix. */
export function toLocal(out: Ray, ray: Ray, worldFromLocal: ArrayLike<number>): void {
  const m = (i: number): number => worldFromLocal[i] ?? 0;
  const x = ray.ox - m(12);
  const y = ray.oy - m(13);
  const z = ray.oz - m(14);
  out.ox = m(0) * x + m(1) * y + m(2) * z;
  out.oy = m(4) * x + m(5) * y + m(6) * z;
  out.oz = m(8) * x + m(9) * y + m(10) * z;
  out.dx = m(0) * ray.dx + m(1) * ray.dy + m(2) * ray.dz;
  out.dy = m(4) * ray.dx + m(5) * ray.dy + m(6) * ray.dz;
  out.dz = m(8) * ray.dx + m(9) * ray.dy + m(10) * ray.dz;
}

/** Rotates the normal from the local space of a rigid matrix to world space. */
export function turnNormal(meeting: Meeting, worldFromLocal: ArrayLike<number>): void {
  const m = (i: number): number => worldFromLocal[i] ?? 0;
  const { nx, ny, nz } = meeting;
  meeting.nx = m(0) * nx + m(4) * ny + m(8) * nz;
  meeting.ny = m(1) * nx + m(5) * ny + m(9) * nz;
  meeting.nz = m(2) * nx + m(6) * ny + m(10) * nz;
}
