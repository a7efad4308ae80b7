import type { FrameClock } from '../../clock.ts';

/** What is played, and where it goes. */
export interface PlaybackHost {
  /** Null while it is not open. */
  readonly durationS: () => number | null;
  /** Shows the recording as it is at `timeS` since its start; false where nothing can be shown yet. */
  readonly show: (timeS: number, playheadS: number, count: number) => boolean;
  /** The recording starts over. */
  readonly onRepeat: () => void;
}

/** Plays a recording in time, from the start again at the end: a frame for each repaint. */
export interface Playback {
  start(): void;
  stop(): void;
  /** The next frame shows this moment, however long ago the last one was. */
  seek(timeS: number): void;
}

export function createPlayback(clock: FrameClock, host: PlaybackHost): Playback {
  /** Runs on over the repeats, so that time never runs backwards. */
  let playheadS = 0;
  let lastS: number | null = null;
  let count = 0;
  let handle = 0;
  const tick = (nowS: number): void => {
    handle = clock.requestFrame(tick);
    const durationS = host.durationS();
    if (durationS === null) return;
    const round = Math.floor(playheadS / durationS);
    if (lastS !== null) playheadS += Math.max(0, nowS - lastS);
    lastS = nowS;
    if (Math.floor(playheadS / durationS) !== round) host.onRepeat();
    if (host.show(playheadS % durationS, playheadS, count)) count++;
  };
  return {
    start: () => {
      lastS = null;
      handle = clock.requestFrame(tick);
    },
    stop: () => clock.cancelFrame(handle),
    seek: (timeS) => {
      playheadS = timeS;
      lastS = null;
      count = 0;
    },
  };
}
