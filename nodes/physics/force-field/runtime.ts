import { Matrix4, Vector3 } from 'three';
import type { PhysicsBody } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Bodies nearer to the center are not accelerated, because directions have no meaning there. */
const CENTER_M = 0.01;

// Filled and read within one call.
const scratchAway = new Vector3();
const scratchForce = new Vector3();
const scratchAxis = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { strength, drag, radiusM } = ctx.params;
  const { kind } = ctx.config;
  const worldFromField = new Matrix4();

  function accelerate({ worldFromBody: m, velocity, acceleration }: PhysicsBody): void {
    scratchAway.set((m[12] ?? 0) - at(12), (m[13] ?? 0) - at(13), (m[14] ?? 0) - at(14));
    const distanceM = scratchAway.length();
    const fade = radiusM.value > 0 ? Math.max(1 - distanceM / radiusM.value, 0) : 1;
    if (fade === 0) return;
    if (kind === 'wind') {
      scratchForce.set(-at(8), -at(9), -at(10)).multiplyScalar(strength.value);
      scratchForce.x -= velocity[0] ?? 0;
      scratchForce.y -= velocity[1] ?? 0;
      scratchForce.z -= velocity[2] ?? 0;
      scratchForce.multiplyScalar(drag.value * fade);
    } else if (kind === 'attractor') {
      if (distanceM < CENTER_M) return;
      scratchForce.copy(scratchAway).multiplyScalar((-strength.value * fade) / distanceM);
    } else {
      scratchAxis.set(at(4), at(5), at(6));
      scratchForce.crossVectors(scratchAxis, scratchAway);
      const length = scratchForce.length();
      if (length < CENTER_M) return;
      scratchForce.multiplyScalar((strength.value * fade) / length);
    }
    acceleration[0] = (acceleration[0] ?? 0) + scratchForce.x;
    acceleration[1] = (acceleration[1] ?? 0) + scratchForce.y;
    acceleration[2] = (acceleration[2] ?? 0) + scratchForce.z;
  }
  function at(index: number): number {
    return worldFromField.elements[index] ?? 0;
  }

  return {
    update: () => {
      const { body: lists, pose } = ctx.inputs;
      if (pose && !pose.valid) return;
      if (pose) worldFromField.fromArray(pose.worldFromPose);
      for (const { bodies } of lists) for (const body of bodies) accelerate(body);
    },
    dispose: () => {},
  };
}
