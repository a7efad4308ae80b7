import { type Body, Plane, Quaternion, type Shape, Sphere, Vec3 } from 'cannon-es';
import { type ContactList, pairKey } from './contact.ts';
import { collideHulls } from './convex-contacts.ts';
import { HullShape } from './hull-shape.ts';
import { collideMesh } from './mesh-contacts.ts';
import { MeshShape } from './mesh-shape.ts';
import { MARGIN_M, type RigidBody } from './rigid-body.ts';
import { collideHullPlane, collideSphereHull, collideSpherePlane, collideSpheres } from './round-contacts.ts';

// Filled and read within one call.
const scratchA = new Vec3();
const scratchB = new Vec3();
const scratchRotation = new Quaternion();

/**
 * Finds the contacts of pairs of bodies. Contacts begin before bodies meet, at a distance that grows with their speed, so that the solver
 * stops them at the surface instead of inside.
 *
 * @param stepS Seconds until contacts are found again.
 * @param linked Keys of pairs that do not collide, because a joint links them.
 */
export function findContacts(as: readonly Body[], bs: readonly Body[], stepS: number, linked: ReadonlySet<number>, out: ContactList): void {
  for (let i = 0; i < as.length; i++) {
    const a = as[i] as RigidBody | undefined;
    const b = bs[i] as RigidBody | undefined;
    if (!a || !b || (!a.isDynamic && !b.isDynamic) || linked.has(pairKey(a, b))) continue;
    const marginM = MARGIN_M + Math.min(reach(a, stepS), a.innerRadiusM) + Math.min(reach(b, stepS), b.innerRadiusM);
    for (let j = 0; j < a.shapes.length; j++) {
      for (let k = 0; k < b.shapes.length; k++) collide(a, j, b, k, marginM, out);
    }
  }
}

function reach({ velocity, isDynamic, sleeps }: RigidBody, stepS: number): number {
  return !isDynamic || sleeps ? 0 : velocity.length() * stepS;
}

function collide(a: RigidBody, j: number, b: RigidBody, k: number, marginM: number, out: ContactList): void {
  const p = a.shapes[j];
  const q = b.shapes[k];
  if (!p || !q) return;
  if (p instanceof MeshShape) {
    if (!(q instanceof MeshShape)) collide(b, k, a, j, marginM, out);
    return;
  }
  if (q instanceof MeshShape) {
    if (p instanceof Sphere) centerOf(a, j, scratchA);
    if (p instanceof Sphere || p instanceof HullShape) collideMesh(b, q, a, p, scratchA, marginM, out);
    return;
  }
  if (p instanceof Sphere) {
    centerOf(a, j, scratchA);
    if (q instanceof Sphere) {
      centerOf(b, k, scratchB);
      collideSpheres(a, p, scratchA, b, q, scratchB, marginM, out);
    } else if (q instanceof HullShape) collideSphereHull(a, p, scratchA, b, q, marginM, out);
    else if (isPlane(q)) {
      planeOf(b, k);
      collideSpherePlane(a, p, scratchA, b, q, scratchB, scratchRotation, marginM, out);
    }
  } else if (p instanceof HullShape) {
    if (q instanceof Sphere) {
      centerOf(b, k, scratchA);
      collideSphereHull(b, q, scratchA, a, p, marginM, out);
    } else if (q instanceof HullShape) collideHulls(a, p, b, q, marginM, out);
    else if (isPlane(q)) {
      planeOf(b, k);
      collideHullPlane(a, p, b, q, scratchB, scratchRotation, marginM, out);
    }
  } else if (isPlane(p) && !isPlane(q)) collide(b, k, a, j, marginM, out);
}

function isPlane(shape: Shape): shape is Plane {
  return shape instanceof Plane;
}

/** Writes the center of a part, world space. */
export function centerOf(body: RigidBody, index: number, out: Vec3): void {
  const offset = body.shapeOffsets[index];
  if (offset) body.quaternion.vmult(offset, out);
  else out.setZero();
  out.vadd(body.position, out);
}

function planeOf(body: RigidBody, index: number): void {
  centerOf(body, index, scratchB);
  const turn = body.shapeOrientations[index];
  if (turn) body.quaternion.mult(turn, scratchRotation);
}
