import { useEffect, useRef } from 'react';

/** Captures Escape, such as to cancel a drag, until the returned function is called. */
export function onEscape(run: () => void): () => void {
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopImmediatePropagation();
    run();
  };
  window.addEventListener('keydown', onKeyDown, true);
  return () => window.removeEventListener('keydown', onKeyDown, true);
}

/** `onEscape` for the drags of one control: one listener at a time, removed on unmount. */
export function useEscape(): { readonly listen: (run: () => void) => void; readonly stop: () => void } {
  const stop = useRef<(() => void) | null>(null);
  useEffect(() => () => stop.current?.(), []);
  return {
    listen: (run) => {
      stop.current?.();
      stop.current = onEscape(run);
    },
    stop: () => stop.current?.(),
  };
}
