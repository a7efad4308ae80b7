import type { MutableFrame } from '../session-frame.ts';
import { createCursor, createGamepadPointer } from './gamepad-pointer.ts';
import { createGamepadReader } from './page-gamepad.ts';
import { createPageKeys } from './page-keys.ts';
import { createPagePointers, type PressClaim } from './page-pointers.ts';
import { deriveTaps } from './session-input.ts';

/** Input on a canvas with one view: pointers, taps, keys and gamepads. */
export interface PageInput {
  /** Fills the input of a frame. Call it once per frame, when the view is set, because points become rays of the view. */
  fill(frame: MutableFrame): void;
  /** Whether a node owns the press of this DOM pointer; gestures of the page then ignore the press. */
  claimOf(domPointerId: number): PressClaim;
  /** Whether a node owns the keys; gestures of the page then ignore them. */
  ownsKeys(): boolean;
  dispose(): void;
}

export function createPageInput(canvas: HTMLCanvasElement): PageInput {
  const pointers = createPagePointers(canvas);
  const keys = createPageKeys(canvas);
  const window = canvas.ownerDocument.defaultView;
  const readGamepad = createGamepadReader();
  const cursor = createCursor(canvas);
  const gamepadPointer = createGamepadPointer(cursor.show);
  let hasGamepads = false;
  const gamepadCame = (): void => {
    hasGamepads = true;
  };
  // Browsers hide gamepads until one is used, so gamepads are not polled before.
  window?.addEventListener('gamepadconnected', gamepadCame);
  return {
    fill: (frame) => {
      const [view] = frame.views;
      frame.input.pointerCount = 0;
      if (view) pointers.fill(frame.input, view);
      keys.fill(frame.input);
      if (hasGamepads && window) {
        readGamepad(frame.input, window.navigator.getGamepads());
        if (view) gamepadPointer.fill(frame.input, view, frame.deltaS);
      }
      deriveTaps(frame.input);
    },
    claimOf: pointers.claimOf,
    ownsKeys: keys.areOwned,
    dispose: () => {
      pointers.dispose();
      keys.dispose();
      cursor.remove();
      window?.removeEventListener('gamepadconnected', gamepadCame);
    },
  };
}
