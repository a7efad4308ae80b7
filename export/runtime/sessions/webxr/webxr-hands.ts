import { HAND_JOINTS } from '../../../../nodes/kit/hand-joints.ts';
import { isPose } from '../../../../nodes/kit/pose.ts';
import type { MutableHand, MutableInput } from '../input/session-input.ts';
import type { XrFrameWithJoints } from './webxr-types.ts';

/** Reads the joints of the bare hands in a WebXR session (WebXR Hand Input). */
export interface WebXrHands {
  /**
   * Sets the hands of the input. Called once per frame. A hand without `hand-tracking`, or with a joint that has no pose, is not tracked.
   */
  fill(input: MutableInput, frame: XRFrame): void;
}

/** The joint spaces of a source, in the order of `HAND_JOINTS`; null if one is missing. */
type Joints = readonly XRJointSpace[] | null;

/**
 * Creates the reader of hands.
 *
 * @param referenceSpace World space.
 */
export function createWebXrHands(session: XRSession, referenceSpace: XRReferenceSpace): WebXrHands {
  // A hand keeps its joint spaces as long as its source exists (WebXR Hand Input §3.1).
  const known = new WeakMap<XRHand, Joints>();
  const scratchPoses = new Float32Array(16 * HAND_JOINTS.length);
  const scratchRadii = new Float32Array(HAND_JOINTS.length);

  const jointsOf = (hand: XRHand): Joints => {
    const cached = known.get(hand);
    if (cached !== undefined) return cached;
    const spaces = HAND_JOINTS.map((joint) => hand.get(joint));
    const joints = spaces.every((space) => space !== undefined) ? (spaces as XRJointSpace[]) : null;
    known.set(hand, joints);
    return joints;
  };
  const read = (out: MutableHand, joints: readonly XRJointSpace[], frame: XrFrameWithJoints): boolean => {
    // Not every browser returns false where a pose is missing, so the numbers are checked, too.
    if (!frame.fillPoses?.(joints, referenceSpace, scratchPoses)) return false;
    for (let i = 0; i < HAND_JOINTS.length; i++) if (!isPose(scratchPoses, 16 * i)) return false;
    frame.fillJointRadii?.(joints, scratchRadii);
    out.worldFromJoints.set(scratchPoses);
    for (let i = 0; i < HAND_JOINTS.length; i++) {
      const radiusM = scratchRadii[i] ?? 0;
      if (radiusM > 0 && Number.isFinite(radiusM)) out.radiiM[i] = radiusM;
      else if (!out.radiiM[i]) out.radiiM[i] = DEFAULT_RADIUS_M;
    }
    return true;
  };
  return {
    fill: ({ leftHand, rightHand }, frame) => {
      leftHand.tracked = false;
      rightHand.tracked = false;
      for (let i = 0; i < session.inputSources.length; i++) {
        const source = session.inputSources[i];
        if (!source?.hand || source.handedness === 'none') continue;
        const out = source.handedness === 'left' ? leftHand : rightHand;
        const joints = jointsOf(source.hand);
        if (!out.tracked && joints) out.tracked = read(out, joints, frame);
      }
    },
  };
}

/** Radius of a joint if the device does not measure it, meters: half the thickness of a finger. */
const DEFAULT_RADIUS_M = 0.008;
