import { useEffect, useRef } from 'react';

/** Until the returned function is called, Escape means this, and nothing else hears of it: a drag that is given up. */
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

/** `onEscape` for the drags of one control: one at a time, and none when the control is gone. */
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
