import { createMatrix } from '../matrix.ts';
import { createPointer, type MutablePointer } from './session-input.ts';

/**
 * A pointer with the state of its press. Events come at any time, but a frame shows one phase, so that a press that begins and ends between
 * two frames is still shown as `start` and then as `end`.
 */
export interface Press {
  readonly pointer: MutablePointer;
  /** Whether the object is in use: its pointer is listed in this frame, or will be in the next. */
  used: boolean;
  began: boolean;
  /** Whether a frame has shown the phase `start`. */
  shown: boolean;
  ended: 'no' | 'end' | 'cancel';
  /** Whether a frame has shown the last phase, `end` or `cancel`. */
  over: boolean;
  /** Matrix for the pointer's `worldFromGrip`, which is null while the grip is not tracked. */
  readonly grip: Float32Array;
}

export function createPress(): Press {
  return { pointer: createPointer(), used: false, began: false, shown: false, ended: 'no', over: false, grip: createMatrix() };
}

/** Starts a press. */
export function beginPress(press: Press): void {
  press.used = true;
  press.began = true;
  press.shown = false;
  press.ended = 'no';
  press.over = false;
  press.pointer.tapped = false;
}

/** Ends a press. Does nothing if there is none. */
export function endPress(press: Press, how: 'end' | 'cancel', tapped: boolean): void {
  if (!press.began || press.ended !== 'no') return;
  press.ended = how;
  press.pointer.tapped = tapped && how === 'end';
}

/** Drops a press that no frame has shown. */
export function dropPress(press: Press): void {
  press.began = false;
  press.ended = 'no';
  press.pointer.tapped = false;
}

/** Sets the pointer's phase to the one that this frame shows. Called once per frame. */
export function showPhase(press: Press): void {
  const { pointer } = press;
  if (press.over) {
    press.over = false;
    press.began = false;
    press.ended = 'no';
    pointer.owner = null;
    pointer.tapped = false;
  }
  if (!press.began) pointer.phase = 'hover';
  else if (!press.shown) {
    pointer.phase = 'start';
    press.shown = true;
  } else if (press.ended === 'no') pointer.phase = 'hold';
  else {
    pointer.phase = press.ended;
    press.over = true;
  }
}
