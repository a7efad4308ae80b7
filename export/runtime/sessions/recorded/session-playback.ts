import type { FrameClock } from '../../clock.ts';

/** The part of a recording that is played. Seconds since its start, later rounds included. */
export interface PlayRange {
  readonly fromS: number;
  /** Where the last frame begins, and where it ends. */
  readonly lastS: number;
  readonly endS: number;
  /** From the end back to `fromS`; else the last frame stays. */
  readonly loop: boolean;
}

/** What is played, and where it goes. */
export interface PlaybackHost {
  /** Null while it is not open. */
  readonly durationS: () => number | null;
  /** Shows the recording as it is at `timeS` since its start, where it can be shown yet. */
  readonly show: (timeS: number) => void;
  /** The recording starts over, and its time goes on. */
  readonly onRepeat: () => void;
  /** Time leapt back to the start of the range. */
  readonly onLoop: () => void;
  /** The range has been played. Its last frame stays for as long as time stands. */
  readonly onEnd: () => void;
}

/** Plays a recording in time, from the start again at the end: a frame for each repaint. */
export interface Playback {
  /** Of the frame that was shown last, or that comes next after a jump. */
  readonly playheadS: number;
  start(): void;
  stop(): void;
  /** The next frame shows this moment, however long ago the last one was. */
  seek(timeS: number): void;
  /** The next frame shows this later moment; the time until then has passed. */
  advanceTo(timeS: number): void;
  setRange(range: PlayRange | null): void;
  /** To its start, where the playhead is outside the range, or at an end that is not gone beyond. True where it jumped. */
  enterRange(): boolean;
}

/** Sums of frame times are off by less. */
const ROUNDING_S = 1e-6;

export function createPlayback(clock: FrameClock, host: PlaybackHost): Playback {
  /** Runs on over the repeats, so that time runs backwards only where it was told to. */
  let playheadS = 0;
  let aheadS: number | null = null;
  let lastS: number | null = null;
  let handle = 0;
  let range: PlayRange | null = null;
  /** False where it came to the end of the range, which says what comes next. */
  const staysInRange = (beforeS: number): boolean => {
    // What was put behind the end plays on there.
    if (range === null || playheadS < range.endS - ROUNDING_S || beforeS >= range.endS - ROUNDING_S) return true;
    if (range.loop) {
      playheadS = range.fromS + (Math.max(0, playheadS - range.endS) % (range.endS - range.fromS));
      host.onLoop();
    } else {
      playheadS = range.lastS;
      host.onEnd();
    }
    return false;
  };
  const tick = (nowS: number): void => {
    handle = clock.requestFrame(tick);
    const durationS = host.durationS();
    if (durationS === null) return;
    const beforeS = playheadS;
    const stepped = aheadS !== null;
    if (aheadS !== null) playheadS = aheadS;
    else if (lastS !== null) playheadS += Math.max(0, nowS - lastS);
    aheadS = null;
    lastS = nowS;
    const roundOf = (timeS: number): number => Math.floor((timeS + ROUNDING_S) / durationS);
    if ((stepped || staysInRange(beforeS)) && roundOf(playheadS) !== roundOf(beforeS)) host.onRepeat();
    host.show(playheadS);
  };
  const seek = (timeS: number): void => {
    playheadS = timeS;
    aheadS = null;
    lastS = null;
  };
  return {
    get playheadS() {
      return aheadS ?? playheadS;
    },
    start: () => {
      lastS = null;
      handle = clock.requestFrame(tick);
    },
    stop: () => clock.cancelFrame(handle),
    seek,
    advanceTo: (timeS) => {
      aheadS = Math.max(timeS, playheadS);
    },
    setRange: (next) => {
      range = next;
    },
    enterRange: () => {
      if (range === null) return false;
      const beyondS = range.loop ? range.endS : range.lastS;
      if (playheadS >= range.fromS - ROUNDING_S && playheadS < beyondS - ROUNDING_S) return false;
      // A range of one frame is there already.
      if (range.lastS === range.fromS && Math.abs(playheadS - range.fromS) < ROUNDING_S) return false;
      seek(range.fromS);
      return true;
    },
  };
}
