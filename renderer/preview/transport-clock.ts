import type { FrameClock } from '../../export/runtime/clock.ts';

/** Time that can be held: sessions and nodes run on it, so that pausing pauses all of them. */
export interface TransportClock extends FrameClock {
  readonly playing: boolean;
  setPlaying(playing: boolean): void;
  /** While held: moves time on by this much, once. */
  step(deltaS: number): void;
  /** While held: asks for a frame at the time it stands at, because something else about the picture changed. */
  wake(): void;
}

/** While nothing changes, a held clock asks for a frame this often: what loads late shows up, and the processor rests. */
const IDLE_S = 0.25;

/**
 * The longest step of time, seconds. While the page is hidden browsers ask for no frames; what plays then goes on where it was,
 * instead of making up for it in one leap.
 */
const MAX_STEP_S = 0.5;

/**
 * Runs with `base` while playing; held, it gives frames of the same time, few and far between. `beforeFrame` runs ahead of every
 * frame's callbacks.
 */
export function createTransportClock(base: FrameClock, beforeFrame: () => void): TransportClock {
  let playing = true;
  let timeS = 0;
  let baseS = base.nowS();
  let nextHandle = 1;
  const callbacks = new Map<number, (timeS: number) => void>();
  let scheduled = false;
  let woken = false;
  let lastFrameS = base.nowS();

  const advance = () => {
    const nowS = base.nowS();
    if (playing) timeS += Math.min(Math.max(0, nowS - baseS), MAX_STEP_S);
    baseS = nowS;
  };
  const tick = () => {
    scheduled = false;
    advance();
    const idle = !playing && !woken && baseS - lastFrameS < IDLE_S;
    if (!idle) {
      woken = false;
      lastFrameS = baseS;
      beforeFrame();
      const due = [...callbacks.values()];
      callbacks.clear();
      for (const callback of due) callback(timeS);
    }
    schedule();
  };
  const schedule = () => {
    if (scheduled || callbacks.size === 0) return;
    scheduled = true;
    base.requestFrame(tick);
  };
  return {
    get playing() {
      return playing;
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
      woken = true;
    },
    step: (deltaS) => {
      advance();
      if (!playing) timeS += deltaS;
      woken = true;
    },
    wake: () => {
      woken = true;
    },
  };
}
