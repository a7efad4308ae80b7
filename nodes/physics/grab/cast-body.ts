import { Matrix4, Vector3 } from 'three';
import type { BodyShape, PhysicsBody } from '../../kit/physics.ts';

// Filled and read within one call.
const bodyFromWorld = new Matrix4();
const from = new Vector3();
const direction = new Vector3();
const a = new Vector3();
const b = new Vector3();
const c = new Vector3();

/**
 * The distance along a ray to a body, meters; infinite if the ray passes it.
 *
 * @param growM The body is thicker by so much, so that small bodies are easier to hit.
 */
export function castOnBody(body: PhysicsBody, originWorld: Vector3, directionWorld: Vector3, growM: number): number {
  bodyFromWorld.fromArray(body.worldFromBody).invert();
  from.copy(originWorld).applyMatrix4(bodyFromWorld);
  direction.copy(directionWorld).transformDirection(bodyFromWorld);
  let nearest = Number.POSITIVE_INFINITY;
  for (const shape of body.description.shapes) nearest = Math.min(nearest, castOnShape(shape, growM));
  return nearest;
}

function castOnShape(shape: BodyShape, growM: number): number {
  switch (shape.kind) {
    case 'plane':
      return Number.POSITIVE_INFINITY;
    case 'sphere': {
      a.set(...shape.centerM).sub(from);
      const along = a.dot(direction);
      const d = along * along - a.lengthSq() + (shape.radiusM + growM) ** 2;
      return d < 0 || along + Math.sqrt(d) < 0 ? Number.POSITIVE_INFINITY : Math.max(along - Math.sqrt(d), 0);
    }
    case 'hull': {
      let enter = 0;
      let leave = Number.POSITIVE_INFINITY;
      for (const face of shape.faces) {
        const [p, q, r] = [shape.verticesM[face[0] ?? 0], shape.verticesM[face[1] ?? 0], shape.verticesM[face[2] ?? 0]];
        if (!p || !q || !r) continue;
        a.set(...p);
        b.set(...q).sub(a);
        c.set(...r).sub(a);
        const normal = b.cross(c).normalize();
        const height = normal.dot(from) - normal.dot(a) - growM;
        const speed = normal.dot(direction);
        if (speed === 0 && height > 0) return Number.POSITIVE_INFINITY;
        if (speed < 0) enter = Math.max(enter, -height / speed);
        else if (speed > 0) leave = Math.min(leave, -height / speed);
      }
      return enter <= leave ? enter : Number.POSITIVE_INFINITY;
    }
  }
}
