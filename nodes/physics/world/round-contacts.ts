import { type Plane, type Quaternion, type Sphere, Vec3 } from 'cannon-es';
import type { ContactList } from './contact.ts';
import type { HullFace, HullShape } from './hull-shape.ts';
import type { RigidBody } from './rigid-body.ts';

// Filled and read within one call.
const scratchClosest = new Vec3();
const scratchCandidate = new Vec3();
const scratchNormal = new Vec3();

export function collideSpheres(
  a: RigidBody,
  sphereA: Sphere,
  centerA: Vec3,
  b: RigidBody,
  sphereB: Sphere,
  centerB: Vec3,
  marginM: number,
  out: ContactList,
): void {
  let x = centerB.x - centerA.x;
  let y = centerB.y - centerA.y;
  let z = centerB.z - centerA.z;
  const distance = Math.hypot(x, y, z);
  const gapM = distance - sphereA.radius - sphereB.radius;
  if (gapM > marginM) return;
  if (distance > 1e-9) {
    x /= distance;
    y /= distance;
    z /= distance;
  } else {
    x = 0;
    y = 1;
    z = 0;
  }
  const r = sphereA.radius;
  out.add(a, b, centerA.x + r * x, centerA.y + r * y, centerA.z + r * z, x, y, z, gapM);
}

/**
 * Adds the contact of a sphere and a polyhedron: at the point of the polyhedron that is closest to the sphere's center, or on the nearest
 * face if the center is inside.
 */
export function collideSphereHull(
  a: RigidBody,
  sphere: Sphere,
  center: Vec3,
  b: RigidBody,
  hull: HullShape,
  marginM: number,
  out: ContactList,
): void {
  const r = sphere.radius;
  let outside = Number.NEGATIVE_INFINITY;
  let nearest: HullFace | null = null;
  for (const face of hull.faces) {
    const gapM = face.normal.dot(center) - face.offset;
    if (gapM > r + marginM) return;
    if (gapM > outside) {
      outside = gapM;
      nearest = face;
    }
  }
  if (!nearest) return;
  if (outside <= 0) {
    const n = nearest.normal;
    // From the sphere into the polyhedron.
    out.add(a, b, center.x - r * n.x, center.y - r * n.y, center.z - r * n.z, -n.x, -n.y, -n.z, outside - r);
    return;
  }
  const distance = closestOnHull(hull, center);
  const gapM = distance - r;
  if (gapM > marginM || distance < 1e-9) return;
  const x = (scratchClosest.x - center.x) / distance;
  const y = (scratchClosest.y - center.y) / distance;
  const z = (scratchClosest.z - center.z) / distance;
  out.add(a, b, center.x + r * x, center.y + r * y, center.z + r * z, x, y, z, gapM);
}

/** Writes the point of the surface that is closest to a point outside. Returns their distance. */
function closestOnHull(hull: HullShape, point: Vec3): number {
  let best = Number.POSITIVE_INFINITY;
  for (const face of hull.faces) {
    const gapM = face.normal.dot(point) - face.offset;
    if (gapM <= 0 || gapM >= best) continue;
    scratchCandidate.set(point.x - gapM * face.normal.x, point.y - gapM * face.normal.y, point.z - gapM * face.normal.z);
    if (!isInside(face, scratchCandidate)) continue;
    best = gapM;
    scratchClosest.copy(scratchCandidate);
  }
  for (const { from, to } of hull.edges) {
    const ux = to.x - from.x;
    const uy = to.y - from.y;
    const uz = to.z - from.z;
    const along = (point.x - from.x) * ux + (point.y - from.y) * uy + (point.z - from.z) * uz;
    const t = Math.min(Math.max(along / (ux * ux + uy * uy + uz * uz), 0), 1);
    const distance = Math.hypot(from.x + t * ux - point.x, from.y + t * uy - point.y, from.z + t * uz - point.z);
    if (distance >= best) continue;
    best = distance;
    scratchClosest.set(from.x + t * ux, from.y + t * uy, from.z + t * uz);
  }
  return best;
}

function isInside({ corners, normal }: HullFace, point: Vec3): boolean {
  for (let i = 0; i < corners.length; i++) {
    const from = corners[i];
    const to = corners[(i + 1) % corners.length];
    if (!from || !to) return false;
    const px = (to.y - from.y) * normal.z - (to.z - from.z) * normal.y;
    const py = (to.z - from.z) * normal.x - (to.x - from.x) * normal.z;
    const pz = (to.x - from.x) * normal.y - (to.y - from.y) * normal.x;
    if (px * (point.x - from.x) + py * (point.y - from.y) + pz * (point.z - from.z) > 0) return false;
  }
  return true;
}

export function collideSpherePlane(
  a: RigidBody,
  sphere: Sphere,
  center: Vec3,
  b: RigidBody,
  _plane: Plane,
  position: Vec3,
  rotation: Quaternion,
  marginM: number,
  out: ContactList,
): void {
  const offset = readPlane(position, rotation);
  const n = scratchNormal;
  const r = sphere.radius;
  const gapM = n.dot(center) - offset - r;
  if (gapM > marginM) return;
  out.add(a, b, center.x - r * n.x, center.y - r * n.y, center.z - r * n.z, -n.x, -n.y, -n.z, gapM);
}

/** Adds the contacts of a polyhedron and a plane: one for each vertex near the plane. */
export function collideHullPlane(
  a: RigidBody,
  hull: HullShape,
  b: RigidBody,
  _plane: Plane,
  position: Vec3,
  rotation: Quaternion,
  marginM: number,
  out: ContactList,
): void {
  const offset = readPlane(position, rotation);
  const n = scratchNormal;
  for (const { x, y, z } of hull.vertices) {
    const gapM = n.x * x + n.y * y + n.z * z - offset;
    if (gapM <= marginM) out.add(a, b, x, y, z, -n.x, -n.y, -n.z, gapM);
  }
}

/** Writes the normal of a plane. Gives its distance from the origin along the normal. */
function readPlane(position: Vec3, rotation: Quaternion): number {
  rotation.vmult(Z, scratchNormal);
  return scratchNormal.dot(position);
}

const Z = new Vec3(0, 0, 1);
