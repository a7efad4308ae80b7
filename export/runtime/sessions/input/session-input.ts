import type { Controller, SessionInput, Tap } from '../../../../nodes/kit/session.ts';
import { createMatrix } from '../matrix.ts';

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

export type MutableTap = Mutable<Tap>;
export type MutableController = Mutable<Controller>;

/** Input that a session overwrites in every frame. */
export interface MutableInput extends SessionInput {
  readonly taps: readonly MutableTap[];
  tapCount: number;
  readonly left: MutableController;
  readonly right: MutableController;
}

/** Maximum taps per frame; further ones are dropped. */
export const MAX_TAPS = 8;

export function createSessionInput(): MutableInput {
  return {
    taps: Array.from({ length: MAX_TAPS }, () => ({ worldFromRay: createMatrix(), by: 'screen' as const })),
    tapCount: 0,
    left: createController(),
    right: createController(),
  };
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
