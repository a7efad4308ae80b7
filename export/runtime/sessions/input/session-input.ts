import { HAND_JOINT_COUNT } from '../../../../nodes/kit/hand-joints.ts';
import { handOf } from '../../../../nodes/kit/pointers.ts';
import type { Controller, Hand, KeyPress, Pointer, PointerKind, SessionInput, Tap } from '../../../../nodes/kit/session.ts';
import { createMatrix } from '../matrix.ts';

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

export type MutableTap = Mutable<Tap>;
export type MutablePointer = Mutable<Pointer>;
export type MutableController = Mutable<Controller>;
export type MutableHand = Mutable<Hand>;
export type MutableKeyPress = Mutable<KeyPress>;

/** Input that a session overwrites in every frame. */
export interface MutableInput extends SessionInput {
  readonly pointers: MutablePointer[];
  pointerCount: number;
  readonly taps: readonly MutableTap[];
  tapCount: number;
  readonly left: MutableController;
  readonly right: MutableController;
  readonly leftHand: MutableHand;
  readonly rightHand: MutableHand;
  readonly keys: readonly MutableKeyPress[];
  keyCount: number;
}

/** Maximum pointers per frame; further ones are dropped. */
export const MAX_POINTERS = 8;

/** Maximum taps per frame; further ones are dropped. */
export const MAX_TAPS = 8;

/** Maximum keys per frame; further ones are dropped. */
export const MAX_KEYS = 8;

/** Creates input without taps, keys and pointers. Its controllers are not connected, and its hands are not tracked. */
export function createSessionInput(): MutableInput {
  return {
    pointers: [],
    pointerCount: 0,
    taps: Array.from({ length: MAX_TAPS }, () => ({ worldFromRay: createMatrix(), by: 'screen' as const })),
    tapCount: 0,
    left: createController(),
    right: createController(),
    leftHand: createHand(),
    rightHand: createHand(),
    keys: Array.from({ length: MAX_KEYS }, () => ({ key: '', shift: false, control: false })),
    keyCount: 0,
    keyOwner: null,
  };
}

export function createPointer(): MutablePointer {
  return {
    id: 0,
    by: 'screen',
    phase: 'hover',
    worldFromRay: createMatrix(),
    worldFromGrip: null,
    pinch: 0,
    tapped: false,
    xrSource: null,
    owner: null,
    ownerDistanceM: 0,
  };
}

/** Adds a pointer to this frame. Returns false if the maximum is reached. */
export function addPointer(input: MutableInput, pointer: MutablePointer): boolean {
  if (input.pointerCount >= MAX_POINTERS) return false;
  input.pointers[input.pointerCount++] = pointer;
  return true;
}

/** Sets the taps of this frame: the presses that end as a tap, in the order of the pointers. */
export function deriveTaps(input: MutableInput): void {
  input.tapCount = 0;
  for (let i = 0; i < input.pointerCount; i++) {
    const pointer = input.pointers[i];
    if (pointer?.phase !== 'end' || !pointer.tapped) continue;
    const tap = nextTap(input);
    if (!tap) return;
    tap.by = tapBy(pointer.by);
    tap.worldFromRay.set(pointer.worldFromRay);
  }
}

function tapBy(by: PointerKind): Tap['by'] {
  return handOf(by) ?? (by === 'gaze' ? 'other' : 'screen');
}

/** Resets a controller to absent. */
export function rest(controller: MutableController): void {
  controller.connected = false;
  controller.stick.fill(0);
  controller.trigger = 0;
  controller.squeeze = 0;
  controller.primary = false;
  controller.secondary = false;
  controller.stickPressed = false;
  controller.worldFromRay = null;
  controller.worldFromGrip = null;
  controller.bare = false;
  controller.haptics = null;
}

/** Returns an unused tap, or null if there are already `MAX_TAPS`. */
export function nextTap(input: MutableInput): MutableTap | null {
  const tap = input.taps[input.tapCount] ?? null;
  if (tap) input.tapCount++;
  return tap;
}

function createController(): MutableController {
  return {
    connected: false,
    stick: new Float32Array(2),
    trigger: 0,
    squeeze: 0,
    primary: false,
    secondary: false,
    stickPressed: false,
    worldFromRay: null,
    worldFromGrip: null,
    bare: false,
    haptics: null,
  };
}

function createHand(): MutableHand {
  const worldFromJoints = new Float32Array(16 * HAND_JOINT_COUNT);
  for (let i = 0; i < worldFromJoints.length; i++) if ((i % 16) % 5 === 0) worldFromJoints[i] = 1;
  return { tracked: false, worldFromJoints, radiiM: new Float32Array(HAND_JOINT_COUNT) };
}
