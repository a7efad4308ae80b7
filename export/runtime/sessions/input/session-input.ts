import { handOf } from '../../../../nodes/kit/pointers.ts';
import type { Controller, Pointer, PointerKind, SessionInput, Tap } from '../../../../nodes/kit/session.ts';
import { createMatrix } from '../matrix.ts';

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

export type MutableTap = Mutable<Tap>;
export type MutablePointer = Mutable<Pointer>;
export type MutableController = Mutable<Controller>;

/** Input that a session overwrites in every frame. */
export interface MutableInput extends SessionInput {
  readonly pointers: MutablePointer[];
  pointerCount: number;
  readonly taps: readonly MutableTap[];
  tapCount: number;
  readonly left: MutableController;
  readonly right: MutableController;
}

/** Maximum pointers per frame; further ones are dropped. */
export const MAX_POINTERS = 8;

/** Maximum taps per frame; further ones are dropped. */
export const MAX_TAPS = 8;

/** @returns Input without taps and pointers, whose controllers are not connected. */
export function createSessionInput(): MutableInput {
  return {
    pointers: [],
    pointerCount: 0,
    taps: Array.from({ length: MAX_TAPS }, () => ({ worldFromRay: createMatrix(), by: 'screen' as const })),
    tapCount: 0,
    left: createController(),
    right: createController(),
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
  };
}

/** Adds a pointer to this frame. Returns false if the maximum is reached. */
export function addPointer(input: MutableInput, pointer: MutablePointer): boolean {
  if (input.pointerCount >= MAX_POINTERS) return false;
  input.pointers[input.pointerCount++] = pointer;
  return true;
}

/** The taps among the pointers of this frame, in their order. */
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
  controller.worldFromRay = null;
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
    worldFromRay: null,
  };
}
