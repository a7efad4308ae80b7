/** Farther than this it is a drag, CSS pixels. */
const STILL_PX = 10;

/**
 * Tells of taps and clicks on an element, and of Enter and the space bar while it has the focus, which tap its middle. Drags and
 * what several fingers do are none; how long one holds does not matter, as in WebXR. Coordinates are UV: origin at the bottom
 * left. Returns what takes the listeners off again.
 */
export function listenForTaps(element: HTMLElement, onTap: (u: number, v: number) => void): () => void {
  const listeners = new AbortController();
  const { signal } = listeners;
  const down = new Map<number, { readonly x: number; readonly y: number }>();
  let isTap = false;
  element.addEventListener(
    'pointerdown',
    (event) => {
      isTap = down.size === 0 && event.button === 0;
      down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    },
    { signal },
  );
  element.addEventListener(
    'pointerup',
    (event) => {
      const start = down.get(event.pointerId);
      down.delete(event.pointerId);
      if (!start || !isTap) return;
      if (Math.hypot(event.clientX - start.x, event.clientY - start.y) > STILL_PX) return;
      const box = element.getBoundingClientRect();
      if (box.width > 0 && box.height > 0) onTap((event.clientX - box.left) / box.width, 1 - (event.clientY - box.top) / box.height);
    },
    { signal },
  );
  element.addEventListener(
    'pointercancel',
    (event) => {
      down.delete(event.pointerId);
    },
    { signal },
  );
  element.addEventListener(
    'keydown',
    (event) => {
      if ((event.key !== 'Enter' && event.key !== ' ') || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      onTap(0.5, 0.5);
    },
    { signal },
  );
  return () => listeners.abort();
}
