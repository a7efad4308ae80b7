/**
 * Time as the runtime sees it, and the only file of the runtime that touches the browser's clocks. Everything else is handed
 * one of these, so that a render repeats and a test needs no sleep.
 */
export interface FrameClock {
  /** Seconds from an arbitrary origin, never running backwards. */
  nowS(): number;
  /** Before the next repaint; the callback gets `nowS` of that moment. */
  requestFrame(callback: (timeS: number) => void): number;
  cancelFrame(handle: number): void;
  /** Resolves after `delayS` seconds, also while nothing is repainted. */
  delay(delayS: number): Promise<void>;
  /** Local date and time into `out`: year, month from 1, day, seconds since midnight, as ISF's `DATE` has them. */
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

/** A clock that moves only when told to. */
export interface ManualClock extends FrameClock {
  /** Moves time on, wakes delays that are over, then runs the frames asked for until now. */
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

/** 1 January 2024, 12:00, whatever the machine's clock says. */
const RENDER_DATE_MS = /* @__PURE__ */ Date.UTC(2024, 0, 1, 12);

/** Of renders, whose frames bring their own time: waiting for drivers and files is not part of it. */
export function createRenderClock(): FrameClock {
  const { delay } = createBrowserClock();
  return { ...createManualClock(0, RENDER_DATE_MS), delay };
}

const DAY_MS = 86_400_000;

/**
 * Milliseconds since 1970 in local time → ISF's `DATE`, without making a `Date` every frame. Days to civil date after
 * Howard Hinnant, "chrono-Compatible Low-Level Date Algorithms", `civil_from_days`.
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
