import type { PressClaim } from '../input/page-pointers.ts';
import type { Orbit } from './orbit-pose.ts';

/** Rotation by a drag over the whole height of the canvas, radians. */
const DRAG_RAD = Math.PI;
const KEY_RAD = 0.1;
const KEY_ZOOM = 1.1;
/** Zoom per wheel pixel; one notch (100 px) changes the distance by a tenth. */
const WHEEL_ZOOM_PER_PX = 0.001;

/** What gestures control: an orbit or a viewer with a position. */
export type GestureTarget = Pick<Orbit, 'rotate' | 'zoom' | 'pan' | 'reset' | 'distanceM'>;

/** Handles gestures on a canvas. The moves of a press are applied only when it is known that no node claims the press. */
export interface OrbitGestures {
  /** Applies the moves of presses that no node claimed. Call it at the start of each frame. */
  settle(): void;
  /** Removes the listeners. */
  dispose(): void;
}

interface Pointer {
  readonly id: number;
  /** Position up to which moves of the pointer are applied, CSS pixels. */
  x: number;
  y: number;
  /** Latest position of the pointer, CSS pixels. */
  toX: number;
  toY: number;
  /** Whether its latest move pans instead of rotating. */
  pans: boolean;
  /** Whether the pointer is up, but its last moves are not applied yet. */
  lifted: boolean;
}

/** The input that nodes of the program own. */
export interface OwnedInput {
  /** Whether a node owns the press of a DOM pointer. */
  claimOf(domPointerId: number): PressClaim;
  /** Whether a node owns the keys. */
  ownsKeys(): boolean;
}

const NOTHING_OWNED: OwnedInput = { claimOf: () => 'free', ownsKeys: () => false };

/**
 * Controls the orbit by mouse, touch and keys. Drag and arrow keys rotate; wheel, pinch, + and − zoom; a drag with the right button, Shift
 * or two fingers pans; Home resets.
 *
 * @param owned - Input that nodes own, which controls no orbit. Absent: none.
 */
export function listenForOrbit(
  canvas: HTMLCanvasElement,
  orbit: GestureTarget,
  tanHalfFovY: () => number,
  { claimOf, ownsKeys }: OwnedInput = NOTHING_OWNED,
): OrbitGestures {
  const listeners = new AbortController();
  const { signal } = listeners;
  const pointers: Pointer[] = [];
  const touchAction = canvas.style.touchAction;
  // Prevents the browser from scrolling on touch.
  canvas.style.touchAction = 'none';
  const tabIndex = canvas.getAttribute('tabindex');
  if (tabIndex === null) canvas.tabIndex = 0;

  const pan = (dx: number, dy: number): void => {
    const metersPerPx = (2 * orbit.distanceM * tanHalfFovY()) / canvas.clientHeight;
    orbit.pan(-dx * metersPerPx, dy * metersPerPx);
  };
  const turn = (dx: number, dy: number): void => {
    const perPx = DRAG_RAD / canvas.clientHeight;
    orbit.rotate(-dx * perPx, dy * perPx);
  };
  /**
   * Applies the movement of a pointer since the last call, unless it is not yet known whether a node claims the press of this or another
   * pointer.
   */
  const apply = (moved: Pointer): void => {
    const claim = claimOf(moved.id);
    if (claim === 'undecided') return;
    let other: Pointer | null = null;
    for (const pointer of pointers) {
      if (pointer === moved) continue;
      const otherClaim = claimOf(pointer.id);
      if (otherClaim === 'undecided') return;
      if (otherClaim === 'free') other = pointer;
    }
    const dx = moved.toX - moved.x;
    const dy = moved.toY - moved.y;
    const before = other ? Math.hypot(moved.x - other.x, moved.y - other.y) : 0;
    moved.x = moved.toX;
    moved.y = moved.toY;
    if (claim === 'claimed' || (dx === 0 && dy === 0)) return;
    if (other) {
      const after = Math.hypot(moved.x - other.x, moved.y - other.y);
      if (before > 0 && after > 0) orbit.zoom(after / before);
      // Each of the two fingers contributes half of the movement.
      pan(dx / 2, dy / 2);
    } else if (moved.pans) {
      pan(dx, dy);
    } else {
      turn(dx, dy);
    }
  };
  const remove = (id: number): void => {
    const index = pointers.findIndex((pointer) => pointer.id === id);
    if (index >= 0) pointers.splice(index, 1);
  };
  canvas.addEventListener(
    'pointerdown',
    ({ pointerId: id, clientX: x, clientY: y }) => {
      if (pointers.some((pointer) => pointer.id === id && pointer.lifted)) remove(id);
      if (pointers.length === 2) return;
      pointers.push({ id, x, y, toX: x, toY: y, pans: false, lifted: false });
      canvas.setPointerCapture(id);
    },
    { signal },
  );
  canvas.addEventListener(
    'pointermove',
    (event) => {
      const moved = pointers.find((pointer) => pointer.id === event.pointerId && !pointer.lifted);
      if (!moved) return;
      moved.toX = event.clientX;
      moved.toY = event.clientY;
      moved.pans = event.shiftKey || (event.buttons & 2) !== 0;
      apply(moved);
    },
    { signal },
  );
  const lift = (event: PointerEvent): void => {
    const lifted = pointers.find((pointer) => pointer.id === event.pointerId);
    if (!lifted) return;
    // Moves before the frame that decided the claim are not applied yet.
    apply(lifted);
    if (claimOf(lifted.id) === 'undecided') lifted.lifted = true;
    else remove(lifted.id);
  };
  canvas.addEventListener('pointerup', lift, { signal });
  canvas.addEventListener('pointercancel', lift, { signal });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const px = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY : event.deltaY * 33;
      orbit.zoom(Math.exp(-px * WHEEL_ZOOM_PER_PX));
    },
    { signal, passive: false },
  );
  canvas.addEventListener(
    'keydown',
    (event) => {
      const action = keyAction(event.key, orbit);
      if (!action || ownsKeys() || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      action();
    },
    { signal },
  );
  return {
    settle: () => {
      for (const pointer of pointers) apply(pointer);
      for (let i = pointers.length - 1; i >= 0; i--) {
        const { id, lifted } = pointers[i] as Pointer;
        if (lifted && claimOf(id) !== 'undecided') pointers.splice(i, 1);
      }
    },
    dispose: () => {
      listeners.abort();
      canvas.style.touchAction = touchAction;
      if (tabIndex === null) canvas.removeAttribute('tabindex');
    },
  };
}

function keyAction(key: string, orbit: GestureTarget): (() => void) | null {
  switch (key) {
    case 'ArrowLeft':
      return () => orbit.rotate(-KEY_RAD, 0);
    case 'ArrowRight':
      return () => orbit.rotate(KEY_RAD, 0);
    case 'ArrowUp':
      return () => orbit.rotate(0, KEY_RAD);
    case 'ArrowDown':
      return () => orbit.rotate(0, -KEY_RAD);
    case '+':
    case '=':
      return () => orbit.zoom(KEY_ZOOM);
    case '-':
      return () => orbit.zoom(1 / KEY_ZOOM);
    case 'Home':
      return () => orbit.reset();
    default:
      return null;
  }
}
