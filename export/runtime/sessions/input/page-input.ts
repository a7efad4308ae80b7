import type { MutableFrame } from '../session-frame.ts';
import { readGamepad } from './page-gamepad.ts';
import { listenForTaps } from './page-taps.ts';
import { MAX_TAPS, nextTap } from './session-input.ts';
import { writeViewRay } from './view-ray.ts';

/** Input on a canvas with one view: taps and gamepads. */
export interface PageInput {
  /** Fills the input of a frame. Call it once per frame, when the view is set, because taps become rays of the view. */
  fill(frame: MutableFrame): void;
  dispose(): void;
}

export function createPageInput(canvas: HTMLCanvasElement): PageInput {
  /** Taps since the last frame, as pairs of UV. */
  const waiting = new Float64Array(2 * MAX_TAPS);
  let count = 0;
  const unlisten = listenForTaps(canvas, (u, v) => {
    if (count === MAX_TAPS) return;
    waiting[2 * count] = u;
    waiting[2 * count + 1] = v;
    count++;
  });
  const window = canvas.ownerDocument.defaultView;
  let hasGamepads = false;
  const gamepadCame = (): void => {
    hasGamepads = true;
  };
  // Browsers hide gamepads until one is used, so gamepads are not polled before.
  window?.addEventListener('gamepadconnected', gamepadCame);
  return {
    fill: (frame) => {
      const [view] = frame.views;
      frame.input.tapCount = 0;
      for (let i = 0; i < count && view; i++) {
        const tap = nextTap(frame.input);
        if (!tap) break;
        tap.by = 'screen';
        writeViewRay(tap.worldFromRay, view, waiting[2 * i] ?? 0, waiting[2 * i + 1] ?? 0);
      }
      count = 0;
      if (hasGamepads && window) readGamepad(frame.input, window.navigator.getGamepads());
    },
    dispose: () => {
      unlisten();
      window?.removeEventListener('gamepadconnected', gamepadCame);
    },
  };
}
