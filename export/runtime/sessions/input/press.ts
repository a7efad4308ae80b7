import { createMatrix } from '../matrix.ts';
import { createPointer, type MutablePointer } from './session-input.ts';

/**
 * A pointer with the events that came since the last frame. Events come at any time; a frame shows one phase, so that a press that begins
 * and ends between two frames is still seen as `start` and then as `end`.
 */
export interface Press {
  readonly pointer: MutablePointer;
  /** It holds a pointer of this frame, or of the next. */
  used: boolean;
  began: boolean;
  /** `start` has been shown. */
  shown: boolean;
  ended: 'no' | 'end' | 'cancel';
  /** Its last phase has been shown. */
  over: boolean;
  /** Whose grip it is while that is tracked. */
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

/** Ends it. Without a press nothing happens. */
export function endPress(press: Press, how: 'end' | 'cancel', tapped: boolean): void {
  if (!press.began || press.ended !== 'no') return;
  press.ended = how;
  press.pointer.tapped = tapped && how === 'end';
}

/** Forgets a press that nobody has seen. */
export function dropPress(press: Press): void {
  press.began = false;
  press.ended = 'no';
  press.pointer.tapped = false;
}

/** Once a frame: the phase that this frame shows. */
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
