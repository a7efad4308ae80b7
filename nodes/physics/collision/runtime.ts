import { Matrix4, Vector3 } from 'three';
import type { Touch } from '../../kit/physics.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

// Filled and read within one call.
const scratchX = new Vector3();
const scratchY = new Vector3();
const scratchZ = new Vector3();
const scratchPose = new Matrix4();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { touched, strength } = ctx.outputs;

  function emit(touch: Touch, bodyKey: string): void {
    const pulse = touched.emit();
    pulse.number = touch.impulseNs;
    pulse.bodyKey = bodyKey;
    scratchY.fromArray(touch.normalWorld);
    // Any axis that is not along the normal.
    scratchX.set(Math.abs(scratchY.x) < 0.9 ? 1 : 0, Math.abs(scratchY.x) < 0.9 ? 0 : 1, 0);
    scratchZ.crossVectors(scratchX, scratchY).normalize();
    scratchX.crossVectors(scratchY, scratchZ);
    scratchPose.makeBasis(scratchX, scratchY, scratchZ).setPosition(scratchX.fromArray(touch.pointWorld));
    pulse.setPose(scratchPose.elements);
  }

  return {
    update: () => {
      strength.value = 0;
      for (const { bodies } of ctx.inputs.body) {
        for (const { touches, key } of bodies) {
          for (let i = 0; i < touches.count; i++) {
            const touch = touches.entries[i];
            if (!touch || touch.impulseNs < ctx.params.leastNs.value) continue;
            emit(touch, key);
            strength.value = Math.max(strength.value, touch.impulseNs);
          }
        }
      }
    },
    dispose: () => {},
  };
}
