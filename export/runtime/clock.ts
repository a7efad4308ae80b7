/**
 * Time for the runtime. This is the only file of the runtime that uses the browser's clocks; everything else gets a clock, so that renders
 * repeat and tests need no sleep.
 */
export interface FrameClock {
  /** Seconds from an arbitrary origin, never decreasing. */
  nowS(): number;
  /** Calls back before the next display frame with `nowS` of that moment. */
  requestFrame(callback: (timeS: number) => void): number;
  cancelFrame(handle: number): void;
  /** Resolves after `delayS` seconds, also without display frames. */
  delay(delayS: number): Promise<void>;
  /** Writes local date and time: year, month from 1, day, seconds since midnight, as ISF's `DATE`. */
  readDate(out: Float64Array): void;
}

export function createBrowserClock(): FrameClock {
  const offsetMs = new Date().getTimezoneOffset() * 60_000;
  return {
    nowS: () => performance.now() / 1000,
    requestFrame: (callback) => requestAnimationFrame((timeMs) => callback(timeMs / 1000)),
    cancelFrame: (handle) => cancelAnimationFrame(handle),
    delay: (delayS) => new Promise((resolve) => setTimeout(resolve, delayS * 1000)),
    readDate: (out) => writeDate(Date.now() - offsetMs, out),
  };
}

/** A clock that only `advance` moves. */
export interface ManualClock extends FrameClock {
  /** Advances the time, resolves delays that have ended, then runs the requested frames. */
  advance(deltaS: number): void;
}

export function createManualClock(startS = 0, localEpochMs = 0): ManualClock {
  let timeS = startS;
  let nextHandle = 1;
  let frames = new Map<number, (timeS: number) => void>();
  let sleepers: { readonly untilS: number; readonly wake: () => void }[] = [];
  return {
    nowS: () => timeS,
    requestFrame: (callback) => {
      frames.set(nextHandle, callback);
      return nextHandle++;
    },
    cancelFrame: (handle) => {
      frames.delete(handle);
    },
    delay: (delayS) =>
      new Promise((resolve) => {
        sleepers.push({ untilS: timeS + delayS, wake: resolve });
      }),
    readDate: (out) => writeDate(localEpochMs + (timeS - startS) * 1000, out),
    advance: (deltaS) => {
      timeS += deltaS;
      const awake = sleepers.filter((s) => s.untilS <= timeS);
      sleepers = sleepers.filter((s) => s.untilS > timeS);
      for (const sleeper of awake) sleeper.wake();
      const due = frames;
      frames = new Map();
      for (const callback of due.values()) callback(timeS);
    },
  };
}

/** The date that shaders read in renders, 1 January 2024, 12:00: independent of the machine's clock. */
const RENDER_DATE_MS = /* @__PURE__ */ Date.UTC(2024, 0, 1, 12);

/** The clock of renders, whose frames have their own time. Only `delay` uses real time. */
export function createRenderClock(): FrameClock {
  const { delay } = createBrowserClock();
  return { ...createManualClock(0, RENDER_DATE_MS), delay };
}

const DAY_MS = 86_400_000;

/**
 * Converts milliseconds since 1970 in local time to ISF's `DATE` without allocating a `Date`. Uses `civil_from_days` of Howard Hinnant,
 * “chrono-Compatible Low-Level Date Algorithms”.
 */
function writeDate(localMs: number, out: Float64Array): void {
  const days = Math.floor(localMs / DAY_MS);
  const fromMarch0000 = days + 719_468;
  const era = Math.floor(fromMarch0000 / 146_097);
  const dayOfEra = fromMarch0000 - era * 146_097;
  const yearOfEra = Math.floor(
    (dayOfEra - Math.floor(dayOfEra / 1460) + Math.floor(dayOfEra / 36_524) - Math.floor(dayOfEra / 146_096)) / 365,
  );
  const dayOfYear = dayOfEra - (365 * yearOfEra + Math.floor(yearOfEra / 4) - Math.floor(yearOfEra / 100));
  const monthFromMarch = Math.floor((5 * dayOfYear + 2) / 153);
  const month = monthFromMarch < 10 ? monthFromMarch + 3 : monthFromMarch - 9;
  out[0] = yearOfEra + era * 400 + (month <= 2 ? 1 : 0);
  out[1] = month;
  out[2] = dayOfYear - Math.floor((153 * monthFromMarch + 2) / 5) + 1;
  out[3] = (localMs - days * DAY_MS) / 1000;
}
