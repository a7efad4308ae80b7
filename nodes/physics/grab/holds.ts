import { Matrix4, type Vector3 } from 'three';
import type { PhysicsBody, PhysicsJoint } from '../../kit/physics.ts';
import { createDragJoint, type DragSpring } from '../../kit/three/drag-joint.ts';

/** What holds a body: a press, given by the id of its pointer, or the closed hand or squeezed controller of a side. */
export type Holder = number | 'left' | 'right';

/** What moves the held body: the pointer's ray, or a pose of the hand or controller. It stays the same while the body is held. */
export type Carrier = 'ray' | 'pinch' | 'palm' | 'grip';

/** The hold on a body. Until `isBegun` it is only requested, because another node may still claim the press. */
export interface Hold {
  readonly by: Holder;
  /** The side of the hand or controller that holds; null for other pointers. */
  readonly hand: 'left' | 'right' | null;
  readonly carrier: Carrier;
  readonly body: PhysicsBody;
  readonly joint: PhysicsJoint;
  /** The pose of the held point, in the axes of the carrier. */
  readonly carrierFromPoint: Matrix4;
  isBegun: boolean;
}

/**
 * Creates a hold.
 *
 * @param pointWorld The point at which the body is held.
 */
export function createHold(
  key: string,
  held: Pick<Hold, 'by' | 'hand' | 'carrier' | 'body'>,
  worldFromCarrier: ArrayLike<number>,
  pointWorld: Vector3,
  spring: DragSpring,
): Hold {
  const joint = createDragJoint(key, held.body, pointWorld, worldFromCarrier, spring);
  const carrierFromPoint = new Matrix4().fromArray(worldFromCarrier).invert().multiply(new Matrix4().fromArray(joint.worldFromTarget));
  return { ...held, joint, carrierFromPoint, isBegun: false };
}

/** Releases the body. Does nothing if its joint is removed already. */
export function endHold({ body, joint }: Hold): void {
  const index = body.joints.indexOf(joint);
  if (index >= 0) body.joints.splice(index, 1);
}
