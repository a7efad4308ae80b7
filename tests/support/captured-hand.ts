import { pinchHandPose } from 'iwer/lib/device/configs/hand/pinch.js';
import { pointHandPose } from 'iwer/lib/device/configs/hand/point.js';
import { relaxedHandPose } from 'iwer/lib/device/configs/hand/relaxed.js';
import { createSessionInput, type MutableHand } from '../../export/runtime/sessions/input/session-input.ts';
import { HAND_JOINTS } from '../../nodes/kit/hand-joints.ts';

/** Poses of a left hand that iwer captured on a Quest. */
const CAPTURED = { relaxed: relaxedHandPose, pinch: pinchHandPose, point: pointHandPose };

/** The joints of a captured left hand, moved by `offsetM` along x. A fist is a pointing hand whose index finger is as bent as the middle one. */
export function captureHand(
  pose: keyof typeof CAPTURED | 'fist',
  offsetM = 0,
  out: MutableHand = createSessionInput().leftHand,
): MutableHand {
  const { jointTransforms } = CAPTURED[pose === 'fist' ? 'point' : pose];
  HAND_JOINTS.forEach((joint, i) => {
    const from = pose === 'fist' ? (joint.replace('index', 'middle') as typeof joint) : joint;
    const { offsetMatrix, radius } = jointTransforms[from];
    out.worldFromJoints.set(Array.from(offsetMatrix), 16 * i);
    out.worldFromJoints[16 * i + 12] = (out.worldFromJoints[16 * i + 12] ?? 0) + offsetM;
    out.radiiM[i] = radius;
  });
  out.tracked = true;
  return out;
}
