import type { Orbit } from './orbit-pose.ts';

/** Rotation of a drag over the height of the canvas. */
const DRAG_RAD = Math.PI;
const KEY_RAD = 0.1;
const KEY_ZOOM = 1.1;
/** Zoom per wheel pixel; one notch (100 px) changes the distance by a tenth. */
const WHEEL_ZOOM_PER_PX = 0.001;

/** What gestures control: an orbit or a viewer with a position. */
export type GestureTarget = Pick<Orbit, 'rotate' | 'zoom' | 'pan' | 'reset' | 'distanceM'>;

interface Pointer {
  readonly id: number;
  x: number;
  y: number;
}

/**
 * Controls the orbit by mouse, touch and keys. Drag and arrow keys rotate; wheel, pinch, + and − zoom; a drag with the right button, Shift
 * or two fingers pans; Home resets. Returns a function that removes the listeners.
 */
export function listenForOrbit(
  canvas: HTMLCanvasElement,
  orbit: GestureTarget,
  tanHalfFovY: () => number,
  isClaimed: (domPointerId: number) => boolean = () => false,
): () => void {
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
  canvas.addEventListener(
    'pointerdown',
    (event) => {
      if (pointers.length === 2) return;
      pointers.push({ id: event.pointerId, x: event.clientX, y: event.clientY });
      canvas.setPointerCapture(event.pointerId);
    },
    { signal },
  );
  canvas.addEventListener(
    'pointermove',
    (event) => {
      const moved = pointers.find((pointer) => pointer.id === event.pointerId);
      if (!moved) return;
      const other = pointers.find((pointer) => pointer !== moved && !isClaimed(pointer.id));
      const dx = event.clientX - moved.x;
      const dy = event.clientY - moved.y;
      const before = other ? Math.hypot(moved.x - other.x, moved.y - other.y) : 0;
      moved.x = event.clientX;
      moved.y = event.clientY;
      if (isClaimed(moved.id)) return;
      if (other) {
        const after = Math.hypot(moved.x - other.x, moved.y - other.y);
        if (before > 0 && after > 0) orbit.zoom(after / before);
        // Each of the two fingers contributes half of the movement.
        pan(dx / 2, dy / 2);
      } else if (event.shiftKey || (event.buttons & 2) !== 0) {
        pan(dx, dy);
      } else {
        turn(dx, dy);
      }
    },
    { signal },
  );
  const lift = (event: PointerEvent): void => {
    const index = pointers.findIndex((pointer) => pointer.id === event.pointerId);
    if (index >= 0) pointers.splice(index, 1);
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
      if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      action();
    },
    { signal },
  );
  return () => {
    listeners.abort();
    canvas.style.touchAction = touchAction;
    if (tabIndex === null) canvas.removeAttribute('tabindex');
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
