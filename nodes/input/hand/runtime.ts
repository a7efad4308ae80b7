import { jointIndex } from '../../kit/hand-joints.ts';
import { grabStrength, pinchStrength, writePalm, writePinch } from '../../kit/hands.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/**
 * A pinch starts at this strength and ends below `OPEN`. Two thresholds (hysteresis): fingertips touch when their joints are 1.5 cm apart,
 * because joints lie inside the fingers, and a pinch ends at 3 cm.
 */
const CLOSED = 0.9;
const OPEN = 0.6;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs } = ctx;
  const isLeft = ctx.config.side === 'left';
  const joint = 16 * jointIndex(ctx.config.joint);
  const worldFromPalm = new Float32Array(16);
  const worldFromPinch = new Float32Array(16);
  /** A view of the chosen joint's matrix in `worldFromJoints`; created again only if that array is another one. */
  let worldFromJoint: Float32Array | null = null;
  let isPinching = false;

  function pulse(output: typeof outputs.pinched, number: number): void {
    const emitted = output.emit();
    emitted.number = number;
    emitted.setPose(worldFromPinch);
  }

  return {
    update: ({ input, jumps }) => {
      const hand = isLeft ? input.leftHand : input.rightHand;
      const { tracked, worldFromJoints } = hand;
      if (worldFromJoint?.buffer !== worldFromJoints.buffer) worldFromJoint = worldFromJoints.subarray(joint, joint + 16);
      if (tracked) {
        writePalm(worldFromPalm, hand);
        writePinch(worldFromPinch, hand);
      }
      writePose(outputs.joint, tracked ? worldFromJoint : null, jumps);
      writePose(outputs.palm, tracked ? worldFromPalm : null, jumps);
      const pinch = pinchStrength(hand);
      outputs.pinch.value = pinch;
      outputs.grab.value = grabStrength(hand);
      outputs.tracked.value = tracked;
      const wasPinching = isPinching;
      isPinching = tracked && pinch >= (wasPinching ? OPEN : CLOSED);
      if (isPinching && !wasPinching) pulse(outputs.pinched, 1);
      if (!isPinching && wasPinching) pulse(outputs.released, tracked ? 1 : 0);
    },
    reset: () => {
      isPinching = false;
    },
    dispose: () => {},
  };
}
