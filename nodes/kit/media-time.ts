import type { Clock } from './runtime.ts';

/** The playback position of a video or sound. */
export interface MediaTime {
  /**
   * The position in this frame. Call it every frame.
   *
   * @param durationS Length of the file, seconds.
   * @param speed Factor on the playback speed; 0 pauses, a negative one plays backwards.
   * @param startS Position at which playback starts, seconds.
   * @param loop Whether playback continues at the start after the end.
   * @returns Seconds, in [0, durationS].
   */
  at(durationS: number, speed: number, startS: number, loop: boolean): number;
  /** Returns to the start. */
  reset(): void;
}

/**
 * Creates a playback position that is a function of the clock, not a sum of frame times: it does not depend on the number of frames
 * or on when the file loaded. A new speed continues from the current position; a new start shifts the position by the difference.
 *
 * @param clock The clock of the node's context, seconds.
 *
 * @example
 * const time = createMediaTime(ctx.clock);
 * const positionS = time.at(video.durationS, 1, 0, true);
 */
export function createMediaTime(clock: Clock): MediaTime {
  // The position was `anchorRunS` at the time `anchorS` of the clock, and has advanced at `rate` since.
  let anchorS = 0;
  let anchorRunS = 0;
  let rate: number | null = null;
  let restart = false;

  const run = (): number => anchorRunS + (clock.timeS - anchorS) * (rate ?? 0);

  return {
    at: (durationS, speed, startS, loop) => {
      if (restart) {
        anchorS = clock.timeS;
        anchorRunS = 0;
        restart = false;
      } else if (rate !== null && rate !== speed) {
        anchorRunS = run();
        anchorS = clock.timeS;
      }
      rate = speed;
      const timeS = startS + run();
      if (!loop) return Math.min(Math.max(timeS, 0), durationS);
      return timeS - durationS * Math.floor(timeS / durationS);
    },
    reset: () => {
      restart = true;
    },
  };
}
