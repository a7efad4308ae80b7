import type { Controller, ViewFrame } from '../../../../nodes/kit/session.ts';
import { beginPress, createPress, endPress, showPhase } from './press.ts';
import { addPointer, type MutableInput } from './session-input.ts';
import { writeViewRay } from './view-ray.ts';

/** Id of the pointer. Fingers, the mouse and recordings use other ids. */
const POINTER_ID = 1 << 19;
/** Deflection of the stick that is ignored, because sticks rest a little off the center. */
const DEAD = 0.2;
/** Speed of the cursor at full deflection, in heights of the view per second. */
const SPEED_PER_S = 0.7;
/** Maximum movement of the cursor during a tap, in heights of the view; a longer one is a drag. */
const STILL = 0.02;
/** Time without use after which the cursor disappears, seconds. */
const REST_S = 4;
/** Longest time step of a movement, seconds, so that the cursor does not jump across the view after a delayed frame. */
const MAX_STEP_S = 0.1;

/** A gamepad as a pointer on a canvas with one view: the left stick moves a cursor, A presses. */
export interface GamepadPointer {
  /** Adds the pointer to the input. Called once per frame, after the controllers of the input and the view are set. */
  fill(input: MutableInput, view: ViewFrame, deltaS: number): void;
}

/**
 * Creates the pointer of a gamepad.
 *
 * @param showCursor Called in each frame with the position of the cursor in view UV, origin at the bottom left; a null `u` hides the
 * cursor.
 */
export function createGamepadPointer(showCursor: (u: number | null, v: number) => void): GamepadPointer {
  const press = createPress();
  const { pointer } = press;
  pointer.id = POINTER_ID;
  pointer.by = 'mouse';
  let [u, v] = [0.5, 0.5];
  let moved = 0;
  let restS = Number.POSITIVE_INFINITY;
  let wasDown = false;

  function move({ stick }: Controller, { viewport }: ViewFrame, deltaS: number): boolean {
    const [x, y] = [stick[0] ?? 0, stick[1] ?? 0];
    const pushed = Math.hypot(x, y);
    if (!(pushed > DEAD)) return false;
    // Squared, for small movements.
    const share = Math.min(1, (pushed - DEAD) / (1 - DEAD)) ** 2 / pushed;
    const by = SPEED_PER_S * share * Math.min(deltaS, MAX_STEP_S);
    const aspect = viewport.widthPx / Math.max(1, viewport.heightPx);
    u = Math.min(1, Math.max(0, u + (x * by) / aspect));
    v = Math.min(1, Math.max(0, v + y * by));
    moved += Math.hypot(x, y) * by;
    return true;
  }
  function hide(): void {
    if (!press.used) return;
    press.used = false;
    pointer.owner = null;
    showCursor(null, 0);
  }

  return {
    fill: (input, view, deltaS) => {
      const { left, right } = input;
      const isDown = right.connected && right.primary;
      const isUsed = move(left, view, deltaS) || isDown || wasDown;
      restS = isUsed ? 0 : restS + deltaS;
      if (isDown && !wasDown) {
        beginPress(press);
        moved = 0;
      }
      // A gamepad that is unplugged in a press does not finish it.
      if (!isDown && wasDown) endPress(press, right.connected ? 'end' : 'cancel', moved <= STILL);
      wasDown = isDown;
      if (restS > REST_S && !press.began) {
        hide();
        return;
      }
      press.used = true;
      showPhase(press);
      showCursor(u, v);
      writeViewRay(pointer.worldFromRay, view, u, v);
      pointer.pinch = pointer.phase === 'start' || pointer.phase === 'hold' ? 1 : 0;
      addPointer(input, pointer);
    },
  };
}

/** Creates the cursor: a ring over the canvas, which shows where the gamepad points. */
export function createCursor(canvas: HTMLCanvasElement): { show(u: number | null, v: number): void; remove(): void } {
  const ring = canvas.ownerDocument.createElement('div');
  // By properties, because the page's policy forbids style attributes.
  Object.assign(ring.style, {
    position: 'absolute',
    width: '18px',
    height: '18px',
    margin: '-11px 0 0 -11px',
    border: '2px solid #fff',
    borderRadius: '50%',
    boxShadow: '0 0 0 2px #000',
    pointerEvents: 'none',
  });
  ring.setAttribute('aria-hidden', 'true');
  return {
    show: (u, v) => {
      if (u === null) {
        ring.remove();
        return;
      }
      if (!ring.isConnected) canvas.after(ring);
      ring.style.left = `${canvas.offsetLeft + u * canvas.clientWidth}px`;
      ring.style.top = `${canvas.offsetTop + (1 - v) * canvas.clientHeight}px`;
    },
    remove: () => ring.remove(),
  };
}
