import type { MutableFrame } from './session-frame.ts';

/**
 * The longest step of time between two frames, seconds. While the page is hidden, the device lost or the graphics away, time
 * stands still: springs and physics go on as if nothing had been, instead of making up for it in one leap.
 */
export const LONGEST_STEP_S = 0.5;

/**
 * Turns what a session's clock says into the time of its frames, which begins at 0, and counts them. While time stands, as in a
 * held preview, the same frame is drawn again: effects that change from frame to frame hold still.
 */
export interface FrameTime {
  /** For every frame that is drawn, and no other. */
  write(frame: MutableFrame, nowS: number): void;
}

export function createFrameTime(): FrameTime {
  let lastS: number | null = null;
  /** Where the frame's time would be 0. */
  let startS = 0;
  return {
    write: (frame, nowS) => {
      if (lastS === null) startS = nowS;
      else startS += Math.max(0, nowS - lastS - LONGEST_STEP_S);
      lastS = nowS;
      const timeS = nowS - startS;
      frame.deltaS = Math.max(0, timeS - frame.timeS);
      if (frame.deltaS > 0) frame.index++;
      frame.timeS = timeS;
    },
  };
}
