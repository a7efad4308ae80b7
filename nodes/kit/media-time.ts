import type { Clock } from './runtime.ts';

/** Where a film or a sound stands. */
export interface MediaTime {
  /** In [0, durationS], for this frame; `speed` 0 holds it. */
  at(durationS: number, speed: number, startS: number, loop: boolean): number;
  /** Back to the beginning. */
  reset(): void;
}

/**
 * A function of the clock, not a sum of frame times: it does not depend on how many frames were drawn or when the file had loaded.
 * A change of speed, or a pause, goes on from the moment it finds; another start moves all by the difference.
 */
export function createMediaTime(clock: Clock): MediaTime {
  // It had run for `anchorRunS` when the clock showed `anchorS`, and has run at `rate` since.
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
