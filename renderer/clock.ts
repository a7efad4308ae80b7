/** The clock of the editor. Injected, so that tests can control time. */
export interface EditorClock {
  /** Calls `run` once after `ms`. The returned function cancels it. */
  after(ms: number, run: () => void): () => void;
  /** Calls `run` before the next paint. The returned function cancels it. */
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

/** Clock of the compiler worker, for measurements. */
export const workerClock = { nowMs: () => performance.now() };

export interface Debounced {
  /** Requests the call and restarts the wait. */
  trigger(): void;
  /** Runs a pending call at once. */
  flush(): void;
  cancel(): void;
}

/**
 * Calls `run` once after a pause of `ms` without further triggers; a function computes the pause at each trigger.
 *
 * @param atMostMs Longest wait after the first trigger. Without it, further triggers extend the wait without limit.
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
