import type { MutableFrame } from './session-frame.ts';

/**
 * Longest time step between two frames, seconds. A longer pause (hidden page, lost device, lost context) is skipped, so that springs and
 * physics continue instead of jumping.
 */
export const MAX_STEP_S = 0.5;

/**
 * Converts a session's clock to frame times, which start at 0, and counts frames. While the time is constant, as in a held preview, the
 * index is constant too, so that effects that vary per frame do not change.
 */
export interface FrameTime {
  /** Sets index, time and time step of a frame. Call it once for each frame that is drawn. */
  write(frame: MutableFrame, nowS: number): void;
}

export function createFrameTime(): FrameTime {
  let lastS: number | null = null;
  /** Clock time of frame time 0. */
  let startS = 0;
  return {
    write: (frame, nowS) => {
      if (lastS === null) startS = nowS;
      else startS += Math.max(0, nowS - lastS - MAX_STEP_S);
      lastS = nowS;
      const timeS = nowS - startS;
      frame.deltaS = Math.max(0, timeS - frame.timeS);
      if (frame.deltaS > 0) frame.index++;
      frame.timeS = timeS;
    },
  };
}
