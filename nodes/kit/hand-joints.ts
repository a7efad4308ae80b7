/**
 * The joints of a hand in the order of WebXR Hand Input §3.1. “metacarpal” is where a finger begins at the wrist, “tip” its end; the
 * thumb has no intermediate phalanx.
 */
export const HAND_JOINTS = [
  'wrist',
  'thumb-metacarpal',
  'thumb-phalanx-proximal',
  'thumb-phalanx-distal',
  'thumb-tip',
  'index-finger-metacarpal',
  'index-finger-phalanx-proximal',
  'index-finger-phalanx-intermediate',
  'index-finger-phalanx-distal',
  'index-finger-tip',
  'middle-finger-metacarpal',
  'middle-finger-phalanx-proximal',
  'middle-finger-phalanx-intermediate',
  'middle-finger-phalanx-distal',
  'middle-finger-tip',
  'ring-finger-metacarpal',
  'ring-finger-phalanx-proximal',
  'ring-finger-phalanx-intermediate',
  'ring-finger-phalanx-distal',
  'ring-finger-tip',
  'pinky-finger-metacarpal',
  'pinky-finger-phalanx-proximal',
  'pinky-finger-phalanx-intermediate',
  'pinky-finger-phalanx-distal',
  'pinky-finger-tip',
] as const;

/** The number of joints. A constant of its own, so that pages that read no hands do not contain the names of the joints. */
export const HAND_JOINT_COUNT = 25;

export type HandJoint = (typeof HAND_JOINTS)[number];

/**
 * The index of a joint.
 *
 * @example
 * isPose(hand.worldFromJoints, 16 * jointIndex('index-finger-tip'));
 */
export function jointIndex(joint: HandJoint): number {
  return HAND_JOINTS.indexOf(joint);
}
