import { Sphere, Vec3 } from 'cannon-es';
import type { Contact, ContactList } from './contact.ts';
import { centerOf } from './find-contacts.ts';
import { HullShape } from './hull-shape.ts';
import { MARGIN_M, type RigidBody } from './rigid-body.ts';
import type { SurfaceField } from './surface-field.ts';

/**
 * Height above the plane of a nearer contact below which a contact is dropped; otherwise a ball would catch on the triangles of a flat
 * surface.
 */
const FLAT_M = 0.004;
/** Cosine of the angle between the normals of two nearby contacts of a polyhedron below which they count as one contact. */
const SAME_POINT_NORMAL = 0.97;

// Filled and read within one call.
const scratchCenter = new Vec3();
const gradient = new Float64Array(3);
const quad = new Float64Array(12);
const closest = new Float64Array(3);
/** The sphere that is being tested: its center, radius and reach. */
const sphere = { x: 0, y: 0, z: 0, radiusM: 0, reach: 0 };
/** How many numbers a candidate contact of the sphere has in `candidates`: normal, distance, and 1 if it is inside a triangle. */
const STRIDE = 5;
const MAX_KEPT = 128;
const candidates = new Float64Array(STRIDE * MAX_KEPT);
let kept = 0;

/**
 * Finds the contacts of a body with the smooth surface of the room. A sphere is tested against the triangles around it, a polyhedron at
 * points that are spread over its surface.
 *
 * @param room The static body that stands for the room.
 */
export function collideSurface(
  room: RigidBody,
  surface: SurfaceField,
  edgeM: number,
  body: RigidBody,
  stepS: number,
  out: ContactList,
): void {
  const marginM = MARGIN_M + Math.min(body.velocity.length() * stepS, Math.max(body.innerRadiusM, edgeM / 2));
  for (let i = 0; i < body.shapes.length; i++) {
    const shape = body.shapes[i];
    if (shape instanceof Sphere) {
      centerOf(body, i, scratchCenter);
      sphere.x = scratchCenter.x;
      sphere.y = scratchCenter.y;
      sphere.z = scratchCenter.z;
      sphere.radiusM = shape.radius;
      sphere.reach = shape.radius + marginM;
      kept = 0;
      meetTriangles(surface, edgeM);
      addKept(room, body, out);
    } else if (shape instanceof HullShape) {
      const first = out.count;
      for (const point of shape.surfacePoints(edgeM / 2)) meetPoint(room, surface, edgeM, body, point, marginM, first, out);
    }
  }
}

function meetTriangles(surface: SurfaceField, edgeM: number): void {
  const { x, y, z, reach } = sphere;
  const low = (p: number) => Math.ceil((p - reach) / edgeM - 1.5);
  const high = (p: number) => Math.floor((p + reach) / edgeM + 0.5);
  for (let vx = low(x); vx <= high(x); vx++) {
    for (let vy = low(y); vy <= high(y); vy++) {
      for (let vz = low(z); vz <= high(z); vz++) {
        const value = surface.at(vx, vy, vz);
        if (Number.isNaN(value)) continue;
        for (let axis = 0; axis < 3; axis++) {
          const next = surface.at(vx + (axis === 0 ? 1 : 0), vy + (axis === 1 ? 1 : 0), vz + (axis === 2 ? 1 : 0));
          if (Number.isNaN(next) || value < 0 === next < 0) continue;
          if (readQuad(surface, vx, vy, vz, axis)) {
            const outward = value < 0 ? 1 : -1;
            meetTriangle(edgeM, 0, 3, 6, axis, outward);
            meetTriangle(edgeM, 0, 6, 9, axis, outward);
          }
        }
      }
    }
  }
}

/** Reads the vertices of the four cells around an edge of the voxel lattice, in a ring. Returns false if one is missing. */
function readQuad(surface: SurfaceField, vx: number, vy: number, vz: number, axis: number): boolean {
  for (let k = 0; k < 4; k++) {
    const s = k === 1 || k === 2 ? 1 : 0;
    const t = k >= 2 ? 1 : 0;
    const x = vx - (axis === 0 ? 0 : axis === 1 ? t : s);
    const y = vy - (axis === 1 ? 0 : axis === 2 ? t : s);
    const z = vz - (axis === 2 ? 0 : axis === 0 ? t : s);
    if (!surface.vertex(x, y, z, quad, 3 * k)) return false;
  }
  return true;
}

/**
 * Tests the sphere against one triangle of the quad, and keeps a contact.
 *
 * @param outward Sign of the normal's component along the axis.
 */
function meetTriangle(edgeM: number, a: number, b: number, c: number, axis: number, outward: number): void {
  const [ax, ay, az] = [quad[a] ?? 0, quad[a + 1] ?? 0, quad[a + 2] ?? 0];
  const [ux, uy, uz] = [(quad[b] ?? 0) - ax, (quad[b + 1] ?? 0) - ay, (quad[b + 2] ?? 0) - az];
  const [vx, vy, vz] = [(quad[c] ?? 0) - ax, (quad[c + 1] ?? 0) - ay, (quad[c + 2] ?? 0) - az];
  let nx = uy * vz - uz * vy;
  let ny = uz * vx - ux * vz;
  let nz = ux * vy - uy * vx;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  if (length < 1e-12) return;
  const sign = (axis === 0 ? nx : axis === 1 ? ny : nz) * outward < 0 ? -1 : 1;
  nx *= sign / length;
  ny *= sign / length;
  nz *= sign / length;
  const { x, y, z, reach } = sphere;
  const height = nx * (x - ax) + ny * (y - ay) + nz * (z - az);
  // A center that is further behind is on the other side of a thing.
  if (height > reach || height < -edgeM) return;
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

/** Adds the kept contacts that are not below others: first those inside triangles, then those on borders; nearest first. */
function addKept(room: RigidBody, body: RigidBody, out: ContactList): void {
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
      const contact = out.add(room, body, x - nx * distance, y - ny * distance, z - nz * distance, nx, ny, nz, distance - radiusM);
      contact.isRoom = true;
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

function meetPoint(
  room: RigidBody,
  surface: SurfaceField,
  edgeM: number,
  body: RigidBody,
  { x, y, z }: Vec3,
  marginM: number,
  first: number,
  out: ContactList,
): void {
  const value = surface.sample(x, y, z, gradient);
  if (!(value < marginM)) return;
  const [gx, gy, gz] = [gradient[0] ?? 0, gradient[1] ?? 0, gradient[2] ?? 0];
  const length = Math.sqrt(gx * gx + gy * gy + gz * gz);
  // The distance has no slope where opposite sides of a thin thing meet.
  if (length < 0.2) return;
  const gapM = value / length;
  if (gapM > marginM) return;
  const [nx, ny, nz] = [gx / length, gy / length, gz / length];
  const [px, py, pz] = [x - nx * gapM, y - ny * gapM, z - nz * gapM];
  for (let i = first; i < out.count; i++) {
    const other = out.at(i);
    if (other.nx * nx + other.ny * ny + other.nz * nz < SAME_POINT_NORMAL || distanceTo(other, room, px, py, pz) > edgeM) continue;
    if (other.gapM <= gapM) return;
  }
  out.add(room, body, px, py, pz, nx, ny, nz, gapM).isRoom = true;
}

function distanceTo({ ax, ay, az }: Contact, { position: p }: RigidBody, x: number, y: number, z: number): number {
  return Math.hypot(ax + p.x - x, ay + p.y - y, az + p.z - z);
}

/** The distance along a ray to the first point at which it meets the surface from its outer side; infinite if there is none. */
export function castOnSurface(surface: SurfaceField, edgeM: number, from: Vec3, direction: Vec3, lengthM: number, normal: Vec3): number {
  const stepM = edgeM / 4;
  let before = Number.NaN;
  let beforeM = 0;
  for (let t = 0; ; t = Math.min(t + stepM, lengthM)) {
    const value = surface.sample(from.x + t * direction.x, from.y + t * direction.y, from.z + t * direction.z, gradient);
    if (before > 0 && value <= 0) {
      const length = Math.hypot(gradient[0] ?? 0, gradient[1] ?? 0, gradient[2] ?? 0);
      if (length > 0) normal.set((gradient[0] ?? 0) / length, (gradient[1] ?? 0) / length, (gradient[2] ?? 0) / length);
      return beforeM + ((t - beforeM) * before) / (before - value);
    }
    before = value;
    beforeM = t;
    if (t >= lengthM) return Number.POSITIVE_INFINITY;
  }
}
