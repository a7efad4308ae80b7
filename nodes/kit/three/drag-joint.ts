import { Matrix4, type Vector3 } from 'three';
import type { PhysicsBody, PhysicsJoint } from '../physics.ts';

/** The spring by which a point of a body is dragged. */
export interface DragSpring {
  readonly frequencyHz: number;
  /** The largest force, newtons; 0 for no limit. */
  readonly maxForceN: number;
}

/**
 * Creates the joint that drags a point of a body towards `worldFromTarget`. The caller adds it to the joints of the body.
 *
 * @param pointWorld The point of the body, where the target is at first; meters.
 * @param worldFromCarrier The axes of the target: column-major 4×4, rigid.
 *
 * @example
 * body.joints.push(createDragJoint('hand', body, point, worldFromHand, { frequencyHz: 5, maxForceN: 200 }));
 */
export function createDragJoint(
  key: string,
  body: PhysicsBody,
  pointWorld: Vector3,
  worldFromCarrier: ArrayLike<number>,
  { frequencyHz, maxForceN }: DragSpring,
): PhysicsJoint {
  const anchor = pointWorld.clone().applyMatrix4(new Matrix4().fromArray(body.worldFromBody).invert());
  return {
    key,
    kind: 'drag',
    a: body,
    b: null,
    description: {
      anchorA: [anchor.x, anchor.y, anchor.z],
      anchorB: [0, 0, 0],
      axisA: [0, 1, 0],
      axisB: [0, 1, 0],
      lengthM: 0,
      frequencyHz,
      dampingRatio: 1,
      maxForceN,
    },
    worldFromTarget: Float64Array.from(new Matrix4().fromArray(worldFromCarrier).setPosition(pointWorld).elements),
    isOn: true,
    version: 0,
  };
}
