import { Matrix4, Vector3 } from 'three';
import type { BodyShape, PhysicsBody } from '../physics.ts';

// Filled and read within one call.
const bodyFromWorld = new Matrix4();
const from = new Vector3();
const direction = new Vector3();
const a = new Vector3();
const b = new Vector3();
const c = new Vector3();

/**
 * Casts a ray at a body.
 *
 * @returns The distance along the ray, meters; infinite if the ray misses the body.
 *
 * @example
 * const distanceM = castOnBody(body, origin, direction);
 */
export function castOnBody(body: PhysicsBody, originWorld: Vector3, directionWorld: Vector3): number {
  bodyFromWorld.fromArray(body.worldFromBody).invert();
  from.copy(originWorld).applyMatrix4(bodyFromWorld);
  direction.copy(directionWorld).transformDirection(bodyFromWorld);
  let nearest = Number.POSITIVE_INFINITY;
  for (const shape of body.description.shapes) nearest = Math.min(nearest, castOnShape(shape));
  return nearest;
}

/**
 * The distance from a point to a body, meters; 0 inside. Near an edge or corner of a polyhedron the result is too small, because distances
 * are measured to the planes of its faces.
 *
 * @example
 * const isNear = distanceToBody(body, point) < 0.05;
 */
export function distanceToBody(body: PhysicsBody, pointWorld: Vector3): number {
  from.copy(pointWorld).applyMatrix4(bodyFromWorld.fromArray(body.worldFromBody).invert());
  let nearest = Number.POSITIVE_INFINITY;
  for (const shape of body.description.shapes) nearest = Math.min(nearest, distanceToShape(shape));
  return nearest;
}

function distanceToShape(shape: BodyShape): number {
  switch (shape.kind) {
    case 'plane':
    case 'mesh':
      return Number.POSITIVE_INFINITY;
    case 'sphere':
      return Math.max(a.set(...shape.centerM).distanceTo(from) - shape.radiusM, 0);
    case 'hull': {
      let most = 0;
      for (const face of shape.faces) if (readFace(shape, face)) most = Math.max(most, b.dot(from) - b.dot(a));
      return most;
    }
  }
}

function castOnShape(shape: BodyShape): number {
  switch (shape.kind) {
    case 'plane':
    case 'mesh':
      return Number.POSITIVE_INFINITY;
    case 'sphere': {
      a.set(...shape.centerM).sub(from);
      const along = a.dot(direction);
      const d = along * along - a.lengthSq() + shape.radiusM ** 2;
      return d < 0 || along + Math.sqrt(d) < 0 ? Number.POSITIVE_INFINITY : Math.max(along - Math.sqrt(d), 0);
    }
    case 'hull': {
      let enter = 0;
      let leave = Number.POSITIVE_INFINITY;
      for (const face of shape.faces) {
        if (!readFace(shape, face)) continue;
        const height = b.dot(from) - b.dot(a);
        const speed = b.dot(direction);
        if (speed === 0 && height > 0) return Number.POSITIVE_INFINITY;
        if (speed < 0) enter = Math.max(enter, -height / speed);
        else if (speed > 0) leave = Math.min(leave, -height / speed);
      }
      return enter <= leave ? enter : Number.POSITIVE_INFINITY;
    }
  }
}

/** Reads the plane of a face: writes one of its vertices to `a` and its normal to `b`. */
function readFace({ verticesM }: Extract<BodyShape, { kind: 'hull' }>, face: readonly number[]): boolean {
  const [p, q, r] = [verticesM[face[0] ?? 0], verticesM[face[1] ?? 0], verticesM[face[2] ?? 0]];
  if (!p || !q || !r) return false;
  a.set(...p);
  b.set(...q).sub(a);
  c.set(...r).sub(a);
  b.cross(c).normalize();
  return true;
}
