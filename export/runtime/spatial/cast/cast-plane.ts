import type { Ray } from '../../../../nodes/kit/hit-test.ts';
import type { DetectedPlane } from '../../../../nodes/kit/session.ts';
import { createRay, type Meeting, toLocal, turnNormal } from '../ray.ts';

// Filled and read within one call.
const scratchRay = createRay();

/**
 * Finds where a ray meets a detected plane, inside its outline.
 *
 * @returns False if the ray meets nothing; `out` is then unchanged.
 */
export function castAtPlane(out: Meeting, ray: Ray, plane: DetectedPlane): boolean {
  toLocal(scratchRay, ray, plane.worldFromSurface);
  const { ox, oy, oz, dx, dy, dz } = scratchRay;
  const distanceM = -oy / dy;
  if (!(distanceM > 0) || distanceM === Number.POSITIVE_INFINITY) return false;
  if (!isInside(ox + dx * distanceM, oz + dz * distanceM, plane.outlineXZ)) return false;
  out.distanceM = distanceM;
  out.nx = 0;
  out.ny = 1;
  out.nz = 0;
  turnNormal(out, plane.worldFromSurface);
  return true;
}

/** Whether a point is inside an outline (even–odd rule). */
function isInside(x: number, z: number, outlineXZ: Float32Array): boolean {
  let inside = false;
  const count = outlineXZ.length;
  for (let i = 0; i < count; i += 2) {
    const ax = outlineXZ[i] ?? 0;
    const az = outlineXZ[i + 1] ?? 0;
    const bx = outlineXZ[(i + 2) % count] ?? 0;
    const bz = outlineXZ[(i + 3) % count] ?? 0;
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
  }
  return inside;
}

/** Finds where a ray meets the floor at y = 0, at most 20 m away: farther points lie behind the walls of any room. */
export function castAtFloor(out: Meeting, ray: Ray): boolean {
  const distanceM = -ray.oy / ray.dy;
  if (!(ray.dy < 0) || !(distanceM > 0) || distanceM > FLOOR_REACH_M) return false;
  out.distanceM = distanceM;
  out.nx = 0;
  out.ny = 1;
  out.nz = 0;
  return true;
}

const FLOOR_REACH_M = 20;
