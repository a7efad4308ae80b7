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

/**
 * Runs `run` once after a rest of `ms`, which a function may decide at each trigger. `atMostMs` limits the whole wait from the first
 * trigger on, however often more follow; without it there is no limit.
 */
export function debounce(clock: Pick<EditorClock, 'after'>, ms: number | (() => number), run: () => void, atMostMs?: number): Debounced {
  let stop: (() => void) | null = null;
  let stopLast: (() => void) | null = null;
  const cancel = () => {
    stop?.();
    stopLast?.();
    stop = null;
    stopLast = null;
  };
  const fire = () => {
    cancel();
    run();
  };
  return {
    trigger: () => {
      stop?.();
      stop = clock.after(typeof ms === 'number' ? ms : ms(), fire);
      if (atMostMs !== undefined) stopLast ??= clock.after(atMostMs, fire);
    },
    flush: () => {
      if (stop === null) return;
      cancel();
      run();
    },
    cancel,
  };
}
