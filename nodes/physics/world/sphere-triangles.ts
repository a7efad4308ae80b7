import type { ContactList } from './contact.ts';
import type { RigidBody } from './rigid-body.ts';

/**
 * Height above the plane of a nearer contact below which a contact is dropped; otherwise a ball would catch on the triangles of a flat
 * surface.
 */
const FLAT_M = 0.004;

// Filled and read within one call.
const closest = new Float64Array(3);
/** How many numbers a candidate contact of the sphere has in `candidates`: normal, distance, and 1 if it is inside a triangle. */
const STRIDE = 5;
const MAX_KEPT = 128;
const candidates = new Float64Array(STRIDE * MAX_KEPT);
let kept = 0;

/** The sphere that is being tested: its center, radius and reach, meters, world space. Set it by `beginSphere`. */
export const sphere = { x: 0, y: 0, z: 0, radiusM: 0, reach: 0 };

/** Begins the contacts of another sphere. Triangles that are farther than the margin from it give none. */
export function beginSphere(
  { x, y, z }: { readonly x: number; readonly y: number; readonly z: number },
  radiusM: number,
  marginM: number,
): void {
  sphere.x = x;
  sphere.y = y;
  sphere.z = z;
  sphere.radiusM = radiusM;
  sphere.reach = radiusM + marginM;
  kept = 0;
}

/**
 * Tests the sphere against a triangle with the corners a, a + u and a + v, and keeps a contact.
 *
 * @param ox A vector to the outer side of the triangle, with `oy` and `oz`.
 * @param behindM A center that is farther behind has no contact.
 */
export function meetTriangle(
  ax: number,
  ay: number,
  az: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
  ox: number,
  oy: number,
  oz: number,
  behindM: number,
): void {
  let nx = uy * vz - uz * vy;
  let ny = uz * vx - ux * vz;
  let nz = ux * vy - uy * vx;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  if (length < 1e-12) return;
  const sign = nx * ox + ny * oy + nz * oz < 0 ? -1 : 1;
  nx *= sign / length;
  ny *= sign / length;
  nz *= sign / length;
  const { x, y, z, reach } = sphere;
  const height = nx * (x - ax) + ny * (y - ay) + nz * (z - az);
  // A center that is further behind is on the other side of a thing.
  if (height > reach || height < -behindM) return;
  const isFace = closestOnTriangle(x - ax, y - ay, z - az, ux, uy, uz, vx, vy, vz);
  const dx = x - ax - (closest[0] ?? 0);
  const dy = y - ay - (closest[1] ?? 0);
  const dz = z - az - (closest[2] ?? 0);
  let distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
  if (distance > reach) return;
  if (height <= 0 || distance < 1e-9) {
    if (!isFace) return;
    distance = height;
  } else {
    nx = dx / distance;
    ny = dy / distance;
    nz = dz / distance;
  }
  keep(nx, ny, nz, distance, isFace);
}

/** Keeps a candidate contact of the sphere for `addKept`. */
function keep(nx: number, ny: number, nz: number, distance: number, isFace: boolean): void {
  if (kept === MAX_KEPT) return;
  candidates.set([nx, ny, nz, distance, isFace ? 1 : 0], STRIDE * kept++);
}

/**
 * Adds the kept contacts that are not below others: first those inside triangles, then those on borders; nearest first.
 *
 * @param owner The body of the triangles.
 */
export function addKept(owner: RigidBody, body: RigidBody, isRoom: boolean, out: ContactList): void {
  const first = out.count;
  for (let wanted = 1; wanted >= 0; wanted--) {
    for (;;) {
      let best = -1;
      for (let i = 0; i < kept; i++) {
        const o = STRIDE * i;
        if (candidates[o + 4] === wanted && (best < 0 || (candidates[o + 3] ?? 0) < (candidates[best + 3] ?? 0))) best = o;
      }
      if (best < 0) break;
      candidates[best + 4] = -1;
      const [nx, ny, nz, distance] = [
        candidates[best] ?? 0,
        candidates[best + 1] ?? 0,
        candidates[best + 2] ?? 0,
        candidates[best + 3] ?? 0,
      ];
      if (isBelow(nx, ny, nz, distance, first, out)) continue;
      const { x, y, z, radiusM } = sphere;
      const contact = out.add(owner, body, x - nx * distance, y - ny * distance, z - nz * distance, nx, ny, nz, distance - radiusM);
      contact.isRoom = isRoom;
      contact.keepsOrder = isRoom;
    }
  }
}

/** Whether the point of a contact lies below the plane of a contact that was added before. */
function isBelow(nx: number, ny: number, nz: number, distance: number, first: number, out: ContactList): boolean {
  for (let i = first; i < out.count; i++) {
    const other = out.at(i);
    const cosine = other.nx * nx + other.ny * ny + other.nz * nz;
    if (cosine * distance >= other.gapM + sphere.radiusM - FLAT_M) return true;
  }
  return false;
}

/**
 * Writes the point of a triangle that is closest to a point, both relative to its first corner (Ericson, “Real-Time Collision Detection”,
 * 2005, §5.1.5).
 *
 * @returns Whether it lies inside the triangle and not on its border.
 */
function closestOnTriangle(
  px: number,
  py: number,
  pz: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
): boolean {
  const d1 = ux * px + uy * py + uz * pz;
  const d2 = vx * px + vy * py + vz * pz;
  if (d1 <= 0 && d2 <= 0) return setClosest(ux, uy, uz, 0, vx, vy, vz, 0, false);
  const uu = ux * ux + uy * uy + uz * uz;
  const uv = ux * vx + uy * vy + uz * vz;
  const vv = vx * vx + vy * vy + vz * vz;
  const d3 = d1 - uu;
  const d4 = d2 - uv;
  if (d3 >= 0 && d4 <= d3) return setClosest(ux, uy, uz, 1, vx, vy, vz, 0, false);
  const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return setClosest(ux, uy, uz, d1 / (d1 - d3), vx, vy, vz, 0, false);
  const d5 = d1 - uv;
  const d6 = d2 - vv;
  if (d6 >= 0 && d5 <= d6) return setClosest(ux, uy, uz, 0, vx, vy, vz, 1, false);
  const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return setClosest(ux, uy, uz, 0, vx, vy, vz, d2 / (d2 - d6), false);
  const va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const t = (d4 - d3) / (d4 - d3 + (d5 - d6));
    return setClosest(ux, uy, uz, 1 - t, vx, vy, vz, t, false);
  }
  const sum = va + vb + vc;
  return setClosest(ux, uy, uz, vb / sum, vx, vy, vz, vc / sum, true);
}

function setClosest(
  ux: number,
  uy: number,
  uz: number,
  s: number,
  vx: number,
  vy: number,
  vz: number,
  t: number,
  isInside: boolean,
): boolean {
  closest[0] = s * ux + t * vx;
  closest[1] = s * uy + t * vy;
  closest[2] = s * uz + t * vz;
  return isInside;
}
