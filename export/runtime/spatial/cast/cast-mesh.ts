import type { Ray } from '../../../../nodes/kit/hit-test.ts';
import type { DetectedMesh } from '../../../../nodes/kit/session.ts';
import { createRay, type Meeting, toLocal, turnNormal } from '../ray.ts';

// Filled and read within one call.
const scratchRay = createRay();

/** The bounding box of a mesh in its local space; computed again when the shape of the mesh changes. */
interface Bounds {
  readonly version: number;
  readonly low: Float64Array;
  readonly high: Float64Array;
}

const boundsOfMesh = new WeakMap<DetectedMesh, Bounds>();

/**
 * Finds where a ray first meets a detected mesh, from either side (Möller and Trumbore, “Fast, Minimum Storage Ray/Triangle Intersection”,
 * 1997).
 *
 * @returns False if the ray meets nothing; `out` is then unchanged.
 */
export function castAtMesh(out: Meeting, ray: Ray, mesh: DetectedMesh): boolean {
  toLocal(scratchRay, ray, mesh.worldFromSurface);
  if (!meetsBox(scratchRay, boundsOf(mesh))) return false;
  const { ox, oy, oz, dx, dy, dz } = scratchRay;
  const { positions: p, indices } = mesh;
  let nearestM = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = 3 * (indices[i] ?? 0);
    const b = 3 * (indices[i + 1] ?? 0);
    const c = 3 * (indices[i + 2] ?? 0);
    const ax = p[a] ?? 0;
    const ay = p[a + 1] ?? 0;
    const az = p[a + 2] ?? 0;
    const ux = (p[b] ?? 0) - ax;
    const uy = (p[b + 1] ?? 0) - ay;
    const uz = (p[b + 2] ?? 0) - az;
    const vx = (p[c] ?? 0) - ax;
    const vy = (p[c + 1] ?? 0) - ay;
    const vz = (p[c + 2] ?? 0) - az;
    const qx = dy * vz - dz * vy;
    const qy = dz * vx - dx * vz;
    const qz = dx * vy - dy * vx;
    const determinant = ux * qx + uy * qy + uz * qz;
    if (Math.abs(determinant) < 1e-12) continue;
    const sx = ox - ax;
    const sy = oy - ay;
    const sz = oz - az;
    const u = (sx * qx + sy * qy + sz * qz) / determinant;
    if (u < 0 || u > 1) continue;
    const rx = sy * uz - sz * uy;
    const ry = sz * ux - sx * uz;
    const rz = sx * uy - sy * ux;
    const v = (dx * rx + dy * ry + dz * rz) / determinant;
    if (v < 0 || u + v > 1) continue;
    const distanceM = (vx * rx + vy * ry + vz * rz) / determinant;
    if (distanceM <= 0 || distanceM >= nearestM) continue;
    nearestM = distanceM;
    out.distanceM = distanceM;
    out.nx = uy * vz - uz * vy;
    out.ny = uz * vx - ux * vz;
    out.nz = ux * vy - uy * vx;
  }
  if (nearestM === Number.POSITIVE_INFINITY) return false;
  turnNormal(out, mesh.worldFromSurface);
  return true;
}

function boundsOf(mesh: DetectedMesh): Bounds {
  const known = boundsOfMesh.get(mesh);
  if (known?.version === mesh.version) return known;
  const low = new Float64Array(3).fill(Number.POSITIVE_INFINITY);
  const high = new Float64Array(3).fill(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < mesh.positions.length; i++) {
    const value = mesh.positions[i] ?? 0;
    low[i % 3] = Math.min(low[i % 3] ?? 0, value);
    high[i % 3] = Math.max(high[i % 3] ?? 0, value);
  }
  const bounds = { version: mesh.version, low, high };
  boundsOfMesh.set(mesh, bounds);
  return bounds;
}

/** Whether a ray meets a box (slab test). */
function meetsBox({ ox, oy, oz, dx, dy, dz }: Ray, { low, high }: Bounds): boolean {
  let enter = 0;
  let leave = Number.POSITIVE_INFINITY;
  for (let axis = 0; axis < 3; axis++) {
    const o = axis === 0 ? ox : axis === 1 ? oy : oz;
    const d = axis === 0 ? dx : axis === 1 ? dy : dz;
    const from = (low[axis] ?? 0) - 1e-6;
    const to = (high[axis] ?? 0) + 1e-6;
    if (Math.abs(d) < 1e-12) {
      if (o < from || o > to) return false;
      continue;
    }
    const a = (from - o) / d;
    const b = (to - o) / d;
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter <= leave;
}
