import { Matrix4, Vector3 } from 'three';
import type { PhysicsBody, PhysicsJoint } from '../../kit/physics.ts';
import { claimPointer, pointerById } from '../../kit/pointers.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Pointer } from '../../kit/session.ts';
import { castOnBody } from './cast-body.ts';
import type { definition } from './definition.ts';

/** A body that a pointer holds. */
interface Hold {
  readonly pointer: number;
  readonly joint: PhysicsJoint;
  /** The point that is held, in the axes of the ray. */
  readonly rayFromPoint: Matrix4;
}

// Filled and read within one call.
const scratchRay = new Matrix4();
const scratchOrigin = new Vector3();
const scratchDirection = new Vector3();
const scratchPoint = new Vector3();
const scratchMatrix = new Matrix4();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { params, outputs } = ctx;
  const holds: Hold[] = [];

  /** What holds: the grip of a hand, otherwise the ray. */
  function frameOf(pointer: Pointer): Readonly<Float32Array> {
    return isHand(pointer) && pointer.worldFromGrip ? pointer.worldFromGrip : pointer.worldFromRay;
  }
  function begin(pointer: Pointer): void {
    scratchRay.fromArray(pointer.worldFromRay);
    scratchOrigin.setFromMatrixPosition(scratchRay);
    scratchDirection.set(-(scratchRay.elements[8] ?? 0), -(scratchRay.elements[9] ?? 0), -(scratchRay.elements[10] ?? 0));
    let best: PhysicsBody | null = null;
    let nearestM = params.farM.value;
    for (const { bodies } of ctx.inputs.body) {
      for (const body of bodies) {
        if (body.description.mode !== 'dynamic' || holds.some(({ joint }) => joint.a === body)) continue;
        const growM = isHand(pointer) ? params.reachM.value : 0;
        const distanceM = castOnBody(body, scratchOrigin, scratchDirection, growM);
        if (distanceM >= nearestM) continue;
        nearestM = distanceM;
        best = body;
      }
    }
    if (!best || !claimPointer(pointer, ctx)) return;
    scratchPoint.copy(scratchDirection).multiplyScalar(nearestM).add(scratchOrigin);
    hold(pointer, best, scratchPoint);
    const pulse = outputs.grabbed.emit();
    pulse.bodyKey = best.key;
    pulse.setPose(pointer.worldFromRay);
  }
  function hold(pointer: Pointer, a: PhysicsBody, pointWorld: Vector3): void {
    scratchMatrix.fromArray(a.worldFromBody).invert();
    const anchor = pointWorld.clone().applyMatrix4(scratchMatrix);
    const worldFromPoint = new Matrix4().fromArray(frameOf(pointer)).setPosition(pointWorld);
    const rayFromPoint = new Matrix4().fromArray(frameOf(pointer)).invert().multiply(worldFromPoint);
    const joint: PhysicsJoint = {
      key: `${ctx.node}/${pointer.id}`,
      kind: 'drag',
      a,
      b: null,
      description: {
        anchorA: [anchor.x, anchor.y, anchor.z],
        anchorB: [0, 0, 0],
        axisA: [0, 1, 0],
        axisB: [0, 1, 0],
        lengthM: 0,
        frequencyHz: params.stiffnessHz.value,
        dampingRatio: 1,
        maxForceN: params.maxForceN.value,
      },
      worldFromTarget: Float64Array.from(worldFromPoint.elements),
      isOn: true,
      version: 0,
    };
    a.joints.push(joint);
    holds.push({ pointer: pointer.id, joint, rayFromPoint });
  }
  function release(index: number): void {
    const [held] = holds.splice(index, 1);
    if (!held) return;
    const { joints, velocity, key } = held.joint.a;
    joints.splice(joints.indexOf(held.joint), 1);
    const pulse = outputs.released.emit();
    pulse.bodyKey = key;
    pulse.number = Math.hypot(velocity[0] ?? 0, velocity[1] ?? 0, velocity[2] ?? 0);
  }
  function forget(): void {
    for (const { joint } of holds.splice(0)) joint.a.joints.splice(joint.a.joints.indexOf(joint), 1);
  }

  return {
    update: ({ input }) => {
      for (let i = holds.length - 1; i >= 0; i--) {
        const held = holds[i];
        const pointer = held && pointerById(input, held.pointer);
        const isOver = !pointer || pointer.phase === 'end' || pointer.phase === 'cancel' || pointer.phase === 'hover';
        // A body that was recycled is in no world any more.
        if (!held || isOver || !held.joint.a.world) {
          release(i);
          continue;
        }
        scratchMatrix.fromArray(frameOf(pointer)).multiply(held.rayFromPoint);
        held.joint.worldFromTarget.set(scratchMatrix.elements);
      }
      for (let i = 0; i < input.pointerCount; i++) {
        const pointer = input.pointers[i];
        if (pointer?.phase === 'start' && pointer.owner === null && pointer.by !== 'gaze') begin(pointer);
      }
      outputs.isHeld.value = holds.length > 0;
    },
    reset: forget,
    dispose: forget,
  };
}

function isHand({ by }: Pointer): boolean {
  return by === 'left-hand' || by === 'right-hand';
}
