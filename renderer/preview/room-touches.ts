import type { Emulator } from '../../export/emulator/emulator.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';

/**
 * Fingers on the screen of an emulated phone by the mouse: a click taps, a drag with Shift is one finger, a drag with Alt two that
 * mirror each other about the middle. Other drags look around (`walk.ts`).
 */
export interface RoomTouches {
  dispose(): void;
}

type Controls = Pick<Emulator, 'press' | 'move' | 'release'>;

const HINT = 'Click: tap · Shift + drag: a finger · Alt + drag: two fingers, to pinch and twist · drag: look around';
/** A press that moves farther looks around. */
const STILL_PX = 4;
/** Frames until a tap is over, so that each sees a press. */
const TAP_FRAMES = 2;

/** Whether the mouse is a finger in this press, so that it does not look around. */
export function isTouch({ shiftKey, altKey }: Pick<PointerEvent, 'shiftKey' | 'altKey'>): boolean {
  return shiftKey || altKey;
}

/** @param hint Shows what the mouse does. */
export function createRoomTouches(emulator: Controls, screen: HTMLElement, hint: HTMLElement, clock: FrameClock): RoomTouches {
  /** Fingers on the screen. */
  let fingers = 0;
  let pointer: number | null = null;
  const start = { x: 0, y: 0, isStill: true };
  let frame = 0;
  /** Frames until the fingers of a tap are lifted. */
  let left = 0;

  const placeOf = (event: PointerEvent): readonly [number, number] => {
    const box = screen.getBoundingClientRect();
    return [(event.clientX - box.left) / Math.max(1, box.width), (event.clientY - box.top) / Math.max(1, box.height)];
  };
  const touch = (how: 'press' | 'move', [x, y]: readonly [number, number]) => {
    emulator[how](x, y, 0);
    if (fingers === 2) emulator[how](1 - x, 1 - y, 1);
  };
  const lift = () => {
    for (let finger = 0; finger < fingers; finger++) emulator.release(finger);
    fingers = 0;
  };
  const count = () => {
    if (--left > 0) frame = clock.requestFrame(count);
    else lift();
  };
  const onDown = (event: PointerEvent) => {
    if (event.button !== 0 || fingers > 0 || pointer !== null) return;
    pointer = event.pointerId;
    Object.assign(start, { x: event.clientX, y: event.clientY, isStill: true });
    if (!isTouch(event)) return;
    fingers = event.altKey ? 2 : 1;
    touch('press', placeOf(event));
  };
  const onMove = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    if (Math.hypot(event.clientX - start.x, event.clientY - start.y) > STILL_PX) start.isStill = false;
    if (fingers > 0) touch('move', placeOf(event));
  };
  const onUp = (event: PointerEvent) => {
    if (event.pointerId !== pointer) return;
    pointer = null;
    if (fingers > 0) {
      lift();
      return;
    }
    if (!start.isStill || event.type === 'pointercancel') return;
    fingers = 1;
    touch('press', placeOf(event));
    left = TAP_FRAMES;
    frame = clock.requestFrame(count);
  };

  const listeners = new AbortController();
  const { signal } = listeners;
  screen.addEventListener('pointerdown', onDown, { signal });
  screen.addEventListener('pointermove', onMove, { signal });
  screen.addEventListener('pointerup', onUp, { signal });
  screen.addEventListener('pointercancel', onUp, { signal });
  hint.textContent = HINT;
  hint.hidden = false;
  return {
    dispose: () => {
      listeners.abort();
      clock.cancelFrame(frame);
      lift();
      hint.hidden = true;
    },
  };
}
