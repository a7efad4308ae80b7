import type { Hand } from './session.ts';

/** Indices of joints in `Hand.worldFromJoints` and `Hand.radiiM`. */
const THUMB_TIP = 4;
const INDEX_TIP = 9;
const MIDDLE_METACARPAL = 10;
const MIDDLE_PROXIMAL = 11;
/** The metacarpals of the four fingers that close to a fist; each is followed by the other joints of its finger. */
const FINGERS = [5, 10, 15, 20] as const;

/** Distances between the tips of thumb and index finger at which a pinch is fully closed, and at which it is open. */
const PINCH_CLOSED_M = 0.01;
const PINCH_OPEN_M = 0.06;

/** The sum of the bend angles of a finger's three joints, in a relaxed hand and in a fist. */
const RELAXED_RAD = (90 * Math.PI) / 180;
const FIST_RAD = (180 * Math.PI) / 180;

/**
 * How far a pinch of thumb and index finger is closed: 1 where the joints of the tips are at most 1 cm apart, because they lie inside the
 * fingers, and 0 from 6 cm on.
 *
 * @returns In [0, 1]; 0 for a hand that is not tracked.
 *
 * @example
 * outputs.pinch.value = pinchStrength(frame.input.leftHand);
 */
export function pinchStrength({ tracked, worldFromJoints }: Hand): number {
  if (!tracked) return 0;
  return clamp01((PINCH_OPEN_M - distance(worldFromJoints, THUMB_TIP, INDEX_TIP)) / (PINCH_OPEN_M - PINCH_CLOSED_M));
}

/**
 * How far the hand is closed to a fist, measured at the finger that is bent least, so that pointing is no grab: 0 where the three joints of
 * that finger bend by at most 90° in sum, as in a relaxed hand, and 1 from 180° on. The thumb does not count.
 *
 * @returns In [0, 1]; 0 for a hand that is not tracked.
 *
 * @example
 * outputs.grab.value = grabStrength(frame.input.leftHand);
 */
export function grabStrength({ tracked, worldFromJoints }: Hand): number {
  if (!tracked) return 0;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < FINGERS.length; i++) least = Math.min(least, bendOf(worldFromJoints, FINGERS[i] ?? 0));
  return clamp01((least - RELAXED_RAD) / (FIST_RAD - RELAXED_RAD));
}

/**
 * Writes the pose of the palm: the center of the middle finger's metacarpal bone, where OpenXR has its palm joint
 * (`XR_HAND_JOINT_PALM_EXT`), with the axes of that bone: -z to the fingers, -y out of the palm.
 *
 * @param out Receives the column-major 4×4, world space.
 *
 * @example
 * if (hand.tracked) writePalm(worldFromPalm, hand);
 */
export function writePalm(out: Float32Array, { worldFromJoints: m }: Hand): void {
  copyMatrix(out, m, MIDDLE_METACARPAL);
  setMiddle(out, m, MIDDLE_METACARPAL, MIDDLE_PROXIMAL);
}

/**
 * Writes the pose of a pinch: the midpoint between the tips of thumb and index finger, with the axes of the index finger's tip.
 *
 * @param out Receives the column-major 4×4, world space.
 *
 * @example
 * if (hand.tracked) writePinch(worldFromPinch, hand);
 */
export function writePinch(out: Float32Array, { worldFromJoints: m }: Hand): void {
  copyMatrix(out, m, INDEX_TIP);
  setMiddle(out, m, THUMB_TIP, INDEX_TIP);
}

/** Sum of the angles between the bones of a finger, radians. */
function bendOf(m: Float32Array, metacarpal: number): number {
  let sum = 0;
  for (let joint = metacarpal + 1; joint < metacarpal + 4; joint++) sum += angleAt(m, joint);
  return sum;
}

/** The angle at a joint between the bone that ends there and the one that begins there, radians; 0 if a bone has no length. */
function angleAt(m: Float32Array, joint: number): number {
  let dot = 0;
  let before = 0;
  let after = 0;
  for (let axis = 12; axis < 15; axis++) {
    const at = m[16 * joint + axis] ?? 0;
    const a = at - (m[16 * (joint - 1) + axis] ?? 0);
    const b = (m[16 * (joint + 1) + axis] ?? 0) - at;
    dot += a * b;
    before += a * a;
    after += b * b;
  }
  const size = Math.sqrt(before * after);
  return size > 0 ? Math.acos(Math.min(1, Math.max(-1, dot / size))) : 0;
}

function distance(m: Float32Array, a: number, b: number): number {
  const along = (axis: number): number => (m[16 * a + axis] ?? 0) - (m[16 * b + axis] ?? 0);
  return Math.hypot(along(12), along(13), along(14));
}

function copyMatrix(out: Float32Array, m: Float32Array, joint: number): void {
  for (let i = 0; i < 16; i++) out[i] = m[16 * joint + i] ?? 0;
}

function setMiddle(out: Float32Array, m: Float32Array, a: number, b: number): void {
  for (let axis = 12; axis < 15; axis++) out[axis] = ((m[16 * a + axis] ?? 0) + (m[16 * b + axis] ?? 0)) / 2;
}

function clamp01(x: number): number {
  return Math.min(1, Math.max(0, x));
}
