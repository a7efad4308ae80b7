import type { MutableFrame } from '../session-frame.ts';
import { readGamepad } from './page-gamepad.ts';
import { listenForTaps } from './page-taps.ts';
import { MAX_TAPS, nextTap } from './session-input.ts';
import { writeViewRay } from './view-ray.ts';

/** What a visitor does at a canvas that shows one view: taps on it, and the page's gamepads. */
export interface PageInput {
  /** Once a frame, when its view is known: taps go through the picture that the visitor sees. */
  fill(frame: MutableFrame): void;
  dispose(): void;
}

export function createPageInput(canvas: HTMLCanvasElement): PageInput {
  /** UV pairs since the last frame. */
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
  // A browser hides gamepads until one is used, and asking every frame costs those who have none.
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
