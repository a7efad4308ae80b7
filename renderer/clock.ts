/** Time as the editor sees it: injected, so that tests can hold it. */
export interface EditorClock {
  /** Calls once after `ms`; the returned function calls it off. */
  after(ms: number, run: () => void): () => void;
  /** Before the next paint. */
  nextFrame(run: () => void): () => void;
}

export const pageClock: EditorClock = {
  after: (ms, run) => {
    const timer = setTimeout(run, ms);
    return () => clearTimeout(timer);
  },
  nextFrame: (run) => {
    const request = requestAnimationFrame(run);
    return () => cancelAnimationFrame(request);
  },
};

/** For measuring. */
export const workerClock = { nowMs: () => performance.now() };

export interface Debounced {
  /** Starts the wait anew. */
  trigger(): void;
  /** Runs at once what is waiting. */
  flush(): void;
  cancel(): void;
}

export function debounce(clock: Pick<EditorClock, 'after'>, ms: number, run: () => void): Debounced {
  let stop: (() => void) | null = null;
  const cancel = () => {
    stop?.();
    stop = null;
  };
  const fire = () => {
    stop = null;
    run();
  };
  return {
    trigger: () => {
      cancel();
      stop = clock.after(ms, fire);
    },
    flush: () => {
      if (stop === null) return;
      cancel();
      run();
    },
    cancel,
  };
}
