import type { ViewFrame } from '../../../../nodes/kit/session.ts';
import { beginPress, createPress, endPress, type Press, showPhase } from './press.ts';
import { addPointer, MAX_POINTERS, type MutableInput } from './session-input.ts';
import { writeViewRay } from './view-ray.ts';

/** A press that moves farther than this is a drag, CSS pixels. */
const STILL_PX = 10;

/** Id of presses by the keyboard, which no DOM pointer has. */
const KEYBOARD = -1;

/**
 * Whether a node owns the press of a DOM pointer. It is undecided until the frame that shows the start of the press, in which nodes may
 * claim it.
 */
export type PressClaim = 'undecided' | 'claimed' | 'free';

/** Fingers, mouse and pen on a canvas that shows one view. */
export interface PagePointers {
  /** Lists the pointers, with rays through their points of the view. Called once per frame, when its view is known. */
  fill(input: MutableInput, view: ViewFrame): void;
  claimOf(domPointerId: number): PressClaim;
  dispose(): void;
}

interface PagePress {
  readonly press: Press;
  domId: number;
  /** Position in view UV, origin at the bottom left. */
  u: number;
  v: number;
  /** Position at the start of the press, in view UV. */
  downU: number;
  downV: number;
  /** Position at the start of the press, CSS pixels. */
  downX: number;
  downY: number;
  /** Whether the press may still become a tap. */
  mayTap: boolean;
  /** Whether it is a mouse or pen that is over the canvas. */
  hovers: boolean;
}

function createPagePress(domId: number): PagePress {
  return { press: createPress(), domId, u: 0.5, v: 0.5, downU: 0.5, downV: 0.5, downX: 0, downY: 0, mayTap: false, hovers: false };
}

/**
 * Whether another press of the same DOM pointer is in use. A press that begins before the last phase of the previous one was shown gets an
 * object of its own.
 */
function hasOther(presses: readonly PagePress[], { domId, press }: PagePress): boolean {
  for (let i = 0; i < presses.length; i++) {
    const other = presses[i];
    if (other?.press.used && other.press !== press && other.domId === domId) return true;
  }
  return false;
}

/**
 * Follows pointers on an element. Enter and the space bar press the middle of the view while the element has the focus. A tap is a press
 * of one finger or the main button that stays within 10 px, however long it lasts, as in WebXR.
 */
export function createPagePointers(element: HTMLElement): PagePointers {
  const listeners = new AbortController();
  const { signal } = listeners;
  const presses: PagePress[] = [];
  let made = 0;
  const { touchAction } = element.style;
  // Otherwise the browser takes two fingers, and drags, for zooming and scrolling, and cancels the pointers.
  element.style.touchAction = 'none';

  const isDown = ({ press }: PagePress): boolean => press.used && press.began && press.ended === 'no';
  const find = (domId: number): PagePress | undefined => presses.find((each) => each.press.used && each.domId === domId && !isEnding(each));
  const isEnding = ({ press }: PagePress): boolean => press.ended !== 'no';
  const take = (domId: number, by: 'screen' | 'mouse'): PagePress | null => {
    const known = presses.find(({ press }) => !press.used);
    if (!known && presses.length === MAX_POINTERS) return null;
    const taken = known ?? createPagePress(domId);
    if (!known) presses.push(taken);
    taken.domId = domId;
    taken.hovers = false;
    const { pointer } = taken.press;
    taken.press.used = true;
    taken.press.began = false;
    taken.press.over = false;
    taken.press.ended = 'no';
    pointer.id = ++made;
    pointer.by = by;
    pointer.owner = null;
    return taken;
  };
  const moveTo = (pressed: PagePress, event: PointerEvent): void => {
    const box = element.getBoundingClientRect();
    if (box.width <= 0 || box.height <= 0) return;
    pressed.u = (event.clientX - box.left) / box.width;
    pressed.v = 1 - (event.clientY - box.top) / box.height;
  };
  const on = <K extends keyof HTMLElementEventMap>(type: K, listener: (event: HTMLElementEventMap[K]) => void): void =>
    element.addEventListener(type, listener, { signal });

  on('pointerdown', (event) => {
    const others = presses.filter(isDown);
    for (const other of others) other.mayTap = false;
    if (event.button !== 0) return;
    const pressed = find(event.pointerId) ?? take(event.pointerId, event.pointerType === 'mouse' ? 'mouse' : 'screen');
    if (!pressed) return;
    moveTo(pressed, event);
    pressed.downU = pressed.u;
    pressed.downV = pressed.v;
    pressed.downX = event.clientX;
    pressed.downY = event.clientY;
    pressed.mayTap = others.length === 0;
    pressed.hovers = event.pointerType !== 'touch';
    beginPress(pressed.press);
  });
  on('pointermove', (event) => {
    let moved = find(event.pointerId);
    // The end of its press is still to be shown, where it was.
    if (!moved && presses.some((each) => each.press.used && each.domId === event.pointerId && isEnding(each))) return;
    if (!moved && event.pointerType === 'mouse' && event.buttons === 0) {
      moved = take(event.pointerId, 'mouse') ?? undefined;
      if (moved) moved.hovers = true;
    }
    if (moved) moveTo(moved, event);
  });
  on('pointerup', (event) => {
    const pressed = find(event.pointerId);
    if (!pressed) return;
    moveTo(pressed, event);
    const isStill = Math.hypot(event.clientX - pressed.downX, event.clientY - pressed.downY) <= STILL_PX;
    endPress(pressed.press, 'end', pressed.mayTap && isStill && event.button === 0);
  });
  on('pointercancel', (event) => {
    const pressed = find(event.pointerId);
    if (pressed) endPress(pressed.press, 'cancel', false);
  });
  on('pointerleave', (event) => {
    for (const each of presses) if (each.domId === event.pointerId) each.hovers = false;
  });
  on('keydown', (event) => {
    if ((event.key !== 'Enter' && event.key !== ' ') || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const pressed = take(KEYBOARD, 'screen');
    if (!pressed) return;
    pressed.u = pressed.downU = 0.5;
    pressed.v = pressed.downV = 0.5;
    beginPress(pressed.press);
    endPress(pressed.press, 'end', true);
  });
  return {
    fill: (input, view) => {
      for (let i = 0; i < presses.length; i++) {
        const pressed = presses[i];
        if (!pressed?.press.used) continue;
        const { press } = pressed;
        const { pointer } = press;
        showPhase(press);
        if (pointer.phase === 'hover' && (!pressed.hovers || hasOther(presses, pressed))) {
          press.used = false;
          continue;
        }
        // A pointer that moved before this frame still starts where it was pressed.
        const starts = pointer.phase === 'start';
        writeViewRay(pointer.worldFromRay, view, starts ? pressed.downU : pressed.u, starts ? pressed.downV : pressed.v);
        pointer.pinch = pointer.phase === 'start' || pointer.phase === 'hold' ? 1 : 0;
        addPointer(input, pointer);
      }
    },
    claimOf: (domPointerId) => {
      let claim: PressClaim = 'free';
      for (let i = 0; i < presses.length; i++) {
        const pressed = presses[i];
        if (!pressed?.press.used || pressed.domId !== domPointerId) continue;
        if (pressed.press.began && !pressed.press.shown) return 'undecided';
        if (pressed.press.pointer.owner !== null) claim = 'claimed';
      }
      return claim;
    },
    dispose: () => {
      listeners.abort();
      element.style.touchAction = touchAction;
    },
  };
}
