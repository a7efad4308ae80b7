import { Matrix4, type Vector3 } from 'three';
import type { PhysicsBody, PhysicsJoint } from '../../kit/physics.ts';

/** What can hold a body: a press of a pointer, by its id, or a closed hand or squeezed controller. */
export type Holder = number | 'left' | 'right';

/** What carries the body: the ray, or a place in the hand. It stays the same while the body is held. */
export type Carrier = 'ray' | 'pinch' | 'palm' | 'grip';

/** A body that is held, or will be from the next frame on: until then another node may take the press. */
export interface Hold {
  readonly by: Holder;
  /** The side that holds, if it is one. */
  readonly hand: 'left' | 'right' | null;
  readonly carrier: Carrier;
  readonly body: PhysicsBody;
  readonly joint: PhysicsJoint;
  /** The point that is held, in the axes of the carrier. */
  readonly carrierFromPoint: Matrix4;
  isBegun: boolean;
}

export interface HoldSettings {
  readonly frequencyHz: number;
  readonly maxForceN: number;
}

/** @param pointWorld Where the body is held. */
export function createHold(
  key: string,
  held: Pick<Hold, 'by' | 'hand' | 'carrier' | 'body'>,
  worldFromCarrier: ArrayLike<number>,
  pointWorld: Vector3,
  { frequencyHz, maxForceN }: HoldSettings,
): Hold {
  const { body } = held;
  const anchor = pointWorld.clone().applyMatrix4(new Matrix4().fromArray(body.worldFromBody).invert());
  const worldFromPoint = new Matrix4().fromArray(worldFromCarrier).setPosition(pointWorld);
  const joint: PhysicsJoint = {
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
    worldFromTarget: Float64Array.from(worldFromPoint.elements),
    isOn: true,
    version: 0,
  };
  const carrierFromPoint = new Matrix4().fromArray(worldFromCarrier).invert().multiply(worldFromPoint);
  return { ...held, joint, carrierFromPoint, isBegun: false };
}

/** Frees the body. A joint that is gone already changes nothing. */
export function endHold({ body, joint }: Hold): void {
  const index = body.joints.indexOf(joint);
  if (index >= 0) body.joints.splice(index, 1);
}
