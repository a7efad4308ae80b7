import { Plane, Quaternion, Sphere, Vec3 } from 'cannon-es';
import { centerOf } from './find-contacts.ts';
import { HullShape } from './hull-shape.ts';
import { MeshShape } from './mesh-shape.ts';
import type { RigidBody } from './rigid-body.ts';

// Filled and read within one call.
const scratchPath = new Vec3();
const scratchCenter = new Vec3();
const scratchNormal = new Vec3();
const hitNormal = new Vec3();
const scratchRotation = new Quaternion();
const Z = new Vec3(0, 0, 1);

/**
 * Casts a ray at a surface that is not a body, such as the room. Returns the distance along the ray and writes the normal; infinite if it
 * meets nothing.
 */
export type CastRoom = (from: Vec3, direction: Vec3, lengthM: number, normal: Vec3) => number;

/**
 * Continuous collision detection: if a body has moved farther in this step than its inner radius, moves it back to the first surface that
 * its center met. It gets the velocity that it had there, so it loses time but no energy.
 *
 * @returns Whether it was stopped.
 */
export function sweep(body: RigidBody, velocityBefore: Vec3, bodies: readonly RigidBody[], castRoom: CastRoom | null): boolean {
  body.position.vsub(body.positionBefore, scratchPath);
  const lengthM = scratchPath.length();
  const r = body.innerRadiusM;
  if (lengthM <= r || lengthM === 0) return false;
  scratchPath.scale(1 / lengthM, scratchPath);
  const farM = lengthM + r;
  let nearest = castRoom ? castRoom(body.positionBefore, scratchPath, farM, hitNormal) : Number.POSITIVE_INFINITY;
  for (const other of bodies) {
    if (other === body || !isNear(other, body, farM)) continue;
    for (let i = 0; i < other.shapes.length; i++) {
      const distance = castOnShape(other, i, body.positionBefore, scratchPath, farM);
      if (distance >= nearest) continue;
      nearest = distance;
      hitNormal.copy(scratchNormal);
    }
  }
  if (nearest > farM) return false;
  const cosine = Math.abs(hitNormal.dot(scratchPath));
  const stopM = nearest - (0.98 * r) / Math.max(cosine, 0.3);
  if (stopM <= 0 || stopM >= lengthM) return false;
  const t = stopM / lengthM;
  const { position: p, positionBefore: q, velocity: v } = body;
  p.set(q.x + scratchPath.x * stopM, q.y + scratchPath.y * stopM, q.z + scratchPath.z * stopM);
  v.set(
    velocityBefore.x + t * (v.x - velocityBefore.x),
    velocityBefore.y + t * (v.y - velocityBefore.y),
    velocityBefore.z + t * (v.z - velocityBefore.z),
  );
  return true;
}

function isNear(other: RigidBody, body: RigidBody, farM: number): boolean {
  const { lowerBound: l, upperBound: u } = other.aabb;
  const { x, y, z } = body.positionBefore;
  return x + farM > l.x && x - farM < u.x && y + farM > l.y && y - farM < u.y && z + farM > l.z && z - farM < u.z;
}

/** Distance along a ray to a shape; infinite if the ray misses it or starts inside. Writes the normal to `scratchNormal`. */
function castOnShape(body: RigidBody, index: number, from: Vec3, direction: Vec3, farM: number): number {
  const shape = body.shapes[index];
  centerOf(body, index, scratchCenter);
  if (shape instanceof Sphere) return castOnSphere(scratchCenter, shape.radius, from, direction);
  if (shape instanceof HullShape) return castOnHull(shape, from, direction);
  if (shape instanceof MeshShape) return shape.cast(from, direction, farM, scratchNormal);
  if (shape instanceof Plane) {
    const turn = body.shapeOrientations[index];
    if (turn) body.quaternion.mult(turn, scratchRotation);
    scratchRotation.vmult(Z, scratchNormal);
    const speed = scratchNormal.dot(direction);
    const height = scratchNormal.dot(from) - scratchNormal.dot(scratchCenter);
    return speed < 0 && height > 0 ? -height / speed : Number.POSITIVE_INFINITY;
  }
  return Number.POSITIVE_INFINITY;
}

function castOnSphere(center: Vec3, radius: number, from: Vec3, direction: Vec3): number {
  const x = from.x - center.x;
  const y = from.y - center.y;
  const z = from.z - center.z;
  const b = x * direction.x + y * direction.y + z * direction.z;
  const c = x * x + y * y + z * z - radius * radius;
  const d = b * b - c;
  if (c <= 0 || b >= 0 || d < 0) return Number.POSITIVE_INFINITY;
  const t = -b - Math.sqrt(d);
  scratchNormal.set((x + t * direction.x) / radius, (y + t * direction.y) / radius, (z + t * direction.z) / radius);
  return t;
}

function castOnHull(hull: HullShape, from: Vec3, direction: Vec3): number {
  let enter = Number.NEGATIVE_INFINITY;
  let leave = Number.POSITIVE_INFINITY;
  for (const { normal, offset } of hull.faces) {
    const height = normal.dot(from) - offset;
    const speed = normal.dot(direction);
    if (speed === 0) {
      if (height > 0) return Number.POSITIVE_INFINITY;
      continue;
    }
    const t = -height / speed;
    if (speed < 0 && t > enter) {
      enter = t;
      scratchNormal.copy(normal);
    } else if (speed > 0 && t < leave) leave = t;
  }
  return enter >= 0 && enter <= leave ? enter : Number.POSITIVE_INFINITY;
}
