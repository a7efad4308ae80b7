import { HAND_JOINTS } from '../../../../nodes/kit/hand-joints.ts';
import { isPose } from '../../../../nodes/kit/pose.ts';
import type { PointerKind, PointerPhase } from '../../../../nodes/kit/session.ts';

/** An object from JSON, whose members have unknown types. */
type Json = Readonly<Record<string, unknown>>;

const KINDS: Readonly<Record<PointerKind, true>> = {
  screen: true,
  mouse: true,
  left: true,
  right: true,
  'left-hand': true,
  'right-hand': true,
  gaze: true,
};
const PHASES: Readonly<Record<PointerPhase, true>> = { hover: true, start: true, hold: true, end: true, cancel: true };

/** Adds to `problems` what is invalid in the recorded input of a frame. `place` says where the input is in the file. */
export function checkInput(value: unknown, place: string, problems: string[]): void {
  const input = asObject(value);
  if (!input) {
    problems.push(`"${place}" must be an object.`);
    return;
  }
  if (input.pointers !== undefined) checkPointers(input.pointers, `${place}.pointers`, problems);
  for (const side of ['left', 'right']) {
    if (input[side] !== undefined) checkController(input[side], `${place}.${side}`, problems);
    const hand = `${side}Hand`;
    if (input[hand] !== undefined) checkHand(input[hand], `${place}.${hand}`, problems);
  }
}

function checkPointers(value: unknown, place: string, problems: string[]): void {
  if (!Array.isArray(value)) {
    problems.push(`"${place}" must be a list.`);
    return;
  }
  const ids = new Set<unknown>();
  value.forEach((each: unknown, i) => {
    const { id, by, phase, worldFromRay, worldFromGrip, pinch } = asObject(each) ?? {};
    const at = `${place}[${i}]`;
    if (!Number.isSafeInteger(id) || Number(id) < 1 || ids.has(id)) problems.push(`"${at}.id" must be a whole number from 1 of its own.`);
    ids.add(id);
    if (!isWord(by, KINDS)) problems.push(`"${at}.by" must be one of ${Object.keys(KINDS).join(', ')}.`);
    if (!isWord(phase, PHASES)) problems.push(`"${at}.phase" must be one of ${Object.keys(PHASES).join(', ')}.`);
    checkPose(worldFromRay, `${at}.worldFromRay`, problems);
    if (worldFromGrip !== undefined) checkPose(worldFromGrip, `${at}.worldFromGrip`, problems);
    if (!isNumber(pinch)) problems.push(`"${at}.pinch" must be a number.`);
  });
}

function checkController(value: unknown, place: string, problems: string[]): void {
  const { stick, trigger, squeeze, worldFromRay, worldFromGrip } = asObject(value) ?? {};
  if (!isNumbers(stick, 2)) problems.push(`"${place}.stick" must be 2 numbers.`);
  if (!isNumber(trigger) || !isNumber(squeeze)) problems.push(`"${place}.trigger" and "${place}.squeeze" must be numbers.`);
  if (worldFromRay !== undefined) checkPose(worldFromRay, `${place}.worldFromRay`, problems);
  if (worldFromGrip !== undefined) checkPose(worldFromGrip, `${place}.worldFromGrip`, problems);
}

function checkHand(value: unknown, place: string, problems: string[]): void {
  const { worldFromJoints, radiiM } = asObject(value) ?? {};
  const count = HAND_JOINTS.length;
  const joints = worldFromJoints as number[];
  if (!isNumbers(worldFromJoints, 16 * count) || !HAND_JOINTS.every((_, i) => isPose(joints, 16 * i))) {
    problems.push(`"${place}.worldFromJoints" must be the poses of ${count} joints, 16 numbers each.`);
  }
  if (!isNumbers(radiiM, count)) problems.push(`"${place}.radiiM" must be ${count} numbers.`);
}

function checkPose(value: unknown, place: string, problems: string[]): void {
  if (!isNumbers(value, 16) || !isPose(value as number[])) problems.push(`"${place}" must be a pose of 16 numbers.`);
}

function isWord(value: unknown, words: Readonly<Record<string, true>>): boolean {
  return typeof value === 'string' && Object.hasOwn(words, value);
}

export function asObject(value: unknown): Json | undefined {
  return typeof value === 'object' && value !== null ? (value as Json) : undefined;
}

export function isNumber(value: unknown): value is number {
  return typeof value === 'number' && Number.isFinite(value);
}

export function isNumbers(value: unknown, count: number): boolean {
  return Array.isArray(value) && value.length === count && value.every(isNumber);
}
