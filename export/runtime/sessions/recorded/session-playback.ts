import type { FrameClock } from '../../clock.ts';

/** The part of a recording to play, in seconds since its first frame. Times continue to increase when the recording repeats. */
export interface PlayRange {
  readonly fromS: number;
  /** Start of the last frame in the range, and end of the range. */
  readonly lastS: number;
  readonly endS: number;
  /** Whether playback repeats from `fromS`; otherwise the last frame stays. */
  readonly loop: boolean;
}

/** The session that a playback controls. */
export interface PlaybackHost {
  /** Duration of the recording; null before it is open. */
  readonly durationS: () => number | null;
  /** Shows the recording at `timeS`, if that frame is decoded. */
  readonly show: (timeS: number) => void;
  /** Called when the recording repeats; its time continues to increase. */
  readonly onRepeat: () => void;
  /** Called when playback jumps back to the start of a range that loops. */
  readonly onLoop: () => void;
  /** Called at the end of a range that does not loop. Its last frame stays. */
  readonly onEnd: () => void;
}

/** Plays a recording in real time, with one frame per display frame, and repeats it. */
export interface Playback {
  /** Time of the frame shown last, or of the next one after a seek. */
  readonly playheadS: number;
  start(): void;
  stop(): void;
  /** Makes the next frame show `timeS`, independent of elapsed time. */
  seek(timeS: number): void;
  /** Makes the next frame show a later time, with the time step up to it. */
  advanceTo(timeS: number): void;
  setRange(range: PlayRange | null): void;
  /**
   * Seeks to the start of the range if the playhead is outside, or at its last frame if the range does not loop. Returns whether it did.
   */
  enterRange(): boolean;
}

/** Tolerance for rounding errors of summed frame times. */
const ROUNDING_S = 1e-6;

export function createPlayback(clock: FrameClock, host: PlaybackHost): Playback {
  /** Time of the playhead, seconds. It continues to increase over repeats and decreases only by seeks and loops. */
  let playheadS = 0;
  let aheadS: number | null = null;
  let lastS: number | null = null;
  let handle = 0;
  let range: PlayRange | null = null;
  /** Loops or stops if the playhead has reached the end of the range, and then returns false. */
  const staysInRange = (beforeS: number): boolean => {
    // A playhead that was set beyond the end continues there.
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
      // The playhead is at the only frame of the range.
      if (range.lastS === range.fromS && Math.abs(playheadS - range.fromS) < ROUNDING_S) return false;
      seek(range.fromS);
      return true;
    },
  };
}
