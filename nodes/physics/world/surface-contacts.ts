import { Sphere, Vec3 } from 'cannon-es';
import type { Contact, ContactList } from './contact.ts';
import { centerOf } from './find-contacts.ts';
import { HullShape } from './hull-shape.ts';
import { MARGIN_M, type RigidBody } from './rigid-body.ts';
import { addKept, beginSphere, meetTriangle, sphere } from './sphere-triangles.ts';
import type { SurfaceField } from './surface-field.ts';

/** Cosine of the angle between the normals of two nearby contacts of a polyhedron below which they count as one contact. */
const SAME_POINT_NORMAL = 0.97;

// Filled and read within one call.
const scratchCenter = new Vec3();
const gradient = new Float64Array(3);
const quad = new Float64Array(12);

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
      beginSphere(scratchCenter, shape.radius, marginM);
      meetTriangles(surface, edgeM);
      addKept(room, body, true, out);
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
            meetQuad(edgeM, 3, 6, axis, outward);
            meetQuad(edgeM, 6, 9, axis, outward);
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
 * Tests the sphere against the triangle of the quad between its first corner and those at offsets b and c.
 *
 * @param outward Sign of the normal's component along the axis.
 */
function meetQuad(edgeM: number, b: number, c: number, axis: number, outward: number): void {
  const [ax, ay, az] = [quad[0] ?? 0, quad[1] ?? 0, quad[2] ?? 0];
  const [ux, uy, uz] = [(quad[b] ?? 0) - ax, (quad[b + 1] ?? 0) - ay, (quad[b + 2] ?? 0) - az];
  const [vx, vy, vz] = [(quad[c] ?? 0) - ax, (quad[c + 1] ?? 0) - ay, (quad[c + 2] ?? 0) - az];
  const [ox, oy, oz] = [axis === 0 ? outward : 0, axis === 1 ? outward : 0, axis === 2 ? outward : 0];
  meetTriangle(ax, ay, az, ux, uy, uz, vx, vy, vz, ox, oy, oz, edgeM);
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
