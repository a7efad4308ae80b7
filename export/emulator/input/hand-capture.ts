import type { P_HAND_INPUT, XRDevice } from 'iwer';
import { Matrix4 } from 'three';
import { HAND_JOINTS, type HandJoint } from '../../../nodes/kit/hand-joints.ts';

export type HandInput = NonNullable<XRDevice['hands']['left']>;

/** iwer's form of a captured left hand: each joint in the space of the target ray, column-major 4×4, and its radius in meters. */
export type HandCapture = HandInput[typeof P_HAND_INPUT]['poses']['default'];

/**
 * Reads a hand in iwer's public form of captures: `{ jointTransforms: { wrist: { offsetMatrix, radius }, … }, gripOffsetMatrix? }`.
 *
 * @throws Error that names what is missing or wrong.
 */
export function readHandCapture(value: unknown): HandCapture {
  const { jointTransforms, gripOffsetMatrix } = (value ?? {}) as { jointTransforms?: unknown; gripOffsetMatrix?: unknown };
  if (typeof jointTransforms !== 'object' || jointTransforms === null) throw new Error('The hand capture has no “jointTransforms”.');
  const joints = jointTransforms as Record<string, { offsetMatrix?: unknown; radius?: unknown } | undefined>;
  for (const joint of HAND_JOINTS) {
    const { offsetMatrix, radius } = joints[joint] ?? {};
    if (!isMatrix(offsetMatrix)) throw new Error(`The hand capture has no “offsetMatrix” of 16 numbers for “${joint}”.`);
    if (!(typeof radius === 'number' && radius > 0)) throw new Error(`The hand capture has no “radius” above 0 for “${joint}”.`);
  }
  if (gripOffsetMatrix !== undefined && !isMatrix(gripOffsetMatrix)) {
    throw new Error('“gripOffsetMatrix” of the hand capture is not a matrix of 16 numbers.');
  }
  return value as HandCapture;
}

function isMatrix(value: unknown): value is number[] {
  return Array.isArray(value) && value.length === 16 && value.every(Number.isFinite);
}

/** Makes a fist from a captured hand that points: the index finger is bent like the middle finger. */
export function closeIndexFinger(pointing: HandCapture): HandCapture {
  const matrixOf = (joint: HandJoint): Matrix4 => new Matrix4().fromArray(Array.from(pointing.jointTransforms[joint].offsetMatrix));
  const jointTransforms = { ...pointing.jointTransforms };
  const rayFromIndex = matrixOf('index-finger-metacarpal');
  const indexFromRay = rayFromIndex.clone().invert();
  const middleFromRay = matrixOf('middle-finger-metacarpal').invert();
  for (const joint of HAND_JOINTS) {
    if (!joint.startsWith('index-finger-') || joint === 'index-finger-metacarpal') continue;
    const middleFromJoint = middleFromRay.clone().multiply(matrixOf(joint.replace('index', 'middle') as HandJoint));
    // The knuckle keeps its place; the others follow in the bends of the middle finger.
    if (joint === 'index-finger-phalanx-proximal') middleFromJoint.copyPosition(indexFromRay.clone().multiply(matrixOf(joint)));
    else middleFromJoint.premultiply(knuckleShift(indexFromRay, middleFromRay, matrixOf));
    const { radius } = pointing.jointTransforms[joint];
    jointTransforms[joint] = { offsetMatrix: rayFromIndex.clone().multiply(middleFromJoint).toArray() as never, radius };
  }
  return { ...pointing, jointTransforms };
}

/** Translation from the knuckle of the middle finger to that of the index finger, each in the space of its finger's metacarpal. */
function knuckleShift(indexFromRay: Matrix4, middleFromRay: Matrix4, matrixOf: (joint: HandJoint) => Matrix4): Matrix4 {
  const index = indexFromRay.clone().multiply(matrixOf('index-finger-phalanx-proximal')).elements;
  const middle = middleFromRay.clone().multiply(matrixOf('middle-finger-phalanx-proximal')).elements;
  const at = (i: number) => (index[i] ?? 0) - (middle[i] ?? 0);
  return new Matrix4().makeTranslation(at(12), at(13), at(14));
}
