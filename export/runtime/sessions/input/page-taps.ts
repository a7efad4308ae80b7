/** Movement beyond which a press is a drag, CSS pixels. */
const STILL_PX = 10;

/**
 * Listens for taps and clicks on an element, and for Enter and Space while it has focus, which tap its center. Drags and gestures with
 * several fingers are not taps; the duration does not matter, as in WebXR.
 *
 * @param onTap Receives UV with the origin at the bottom left.
 * @returns A function that removes the listeners.
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
