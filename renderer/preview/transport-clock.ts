import type { FrameClock } from '../../export/runtime/clock.ts';

/** A clock that can be paused. Sessions and nodes use it, so that a pause affects all of them. */
export interface TransportClock extends FrameClock {
  readonly playing: boolean;
  /** Whether the frame whose callbacks run was asked for, by `wake` for example, so that it is drawn even if nothing seems to have changed. */
  readonly asked: boolean;
  /** Whether that frame was not asked for, and time stands. */
  readonly idle: boolean;
  setPlaying(playing: boolean): void;
  /** While paused: advances the time once. */
  step(deltaS: number): void;
  /** While paused: requests a frame at the same time, because something else has changed. */
  wake(): void;
  /** Wakes it after a delay in seconds, once for all calls meanwhile. */
  wakeIn(restS: number): void;
}

/** Frame interval of a paused clock without changes. Frames still follow, to show what finishes loading late, but slowly, to save power. */
const IDLE_S = 0.25;

/**
 * Maximum step in seconds. Browsers request no frames while the page is hidden; afterwards time continues where it was instead of
 * jumping.
 */
const MAX_STEP_S = 0.5;

/**
 * Creates a clock. While playing, it follows `base`. While paused, it calls back at a low rate with the same time. `beforeFrame` runs
 * before the callbacks of each frame.
 */
export function createTransportClock(base: FrameClock, beforeFrame: () => void): TransportClock {
  let playing = true;
  let timeS = 0;
  let baseS = base.nowS();
  let nextHandle = 1;
  const callbacks = new Map<number, (timeS: number) => void>();
  let requested = false;
  let resting = false;
  let woken = false;
  let asked = false;
  let idle = false;
  let sleeping = false;

  const advance = () => {
    const nowS = base.nowS();
    if (playing) timeS += Math.min(Math.max(0, nowS - baseS), MAX_STEP_S);
    baseS = nowS;
  };
  const tick = () => {
    requested = false;
    advance();
    idle = !playing && !woken;
    asked = woken;
    woken = false;
    beforeFrame();
    const due = [...callbacks.values()];
    callbacks.clear();
    for (const callback of due) callback(timeS);
    schedule();
  };
  const request = () => {
    if (requested || callbacks.size === 0) return;
    requested = true;
    base.requestFrame(tick);
  };
  /** A requested frame makes the browser compose the page, even if it draws nothing. */
  const rest = () => {
    if (resting) return;
    resting = true;
    void base.delay(IDLE_S).then(() => {
      resting = false;
      request();
    });
  };
  const schedule = () => {
    if (callbacks.size === 0) return;
    if (playing || woken) request();
    else rest();
  };
  const wake = () => {
    woken = true;
    schedule();
  };
  return {
    get playing() {
      return playing;
    },
    get asked() {
      return asked;
    },
    get idle() {
      return idle;
    },
    nowS: () => {
      advance();
      return timeS;
    },
    requestFrame: (callback) => {
      const handle = nextHandle++;
      callbacks.set(handle, callback);
      schedule();
      return handle;
    },
    cancelFrame: (handle) => {
      callbacks.delete(handle);
    },
    delay: base.delay,
    readDate: base.readDate,
    setPlaying: (next) => {
      advance();
      playing = next;
      wake();
    },
    step: (deltaS) => {
      advance();
      if (!playing) timeS += deltaS;
      wake();
    },
    wake,
    wakeIn: (restS) => {
      if (sleeping) return;
      sleeping = true;
      void base.delay(restS).then(() => {
        sleeping = false;
        wake();
      });
    },
  };
}
