import type { FrameClock } from '../runtime/clock.ts';

/** Schedules the frames of sessions and their times. */
export interface FrameSource {
  /** Calls `runFrame` with the time in seconds until the returned function is called. `runFrame` returns whether it drew a frame. */
  start(runFrame: (timeS: number) => boolean): () => void;
  /**
   * Runs one frame of every session now.
   *
   * @throws Error if the source is not manual.
   */
  step(): void;
  readonly manual: boolean;
}

/** Creates a source that runs a frame with each frame of the display, at the display's time. */
export function createFreeSource(clock: FrameClock): FrameSource {
  return {
    manual: false,
    start: (runFrame) => {
      let handle: number | null = null;
      const tick = (timeS: number): void => {
        handle = clock.requestFrame(tick);
        runFrame(timeS);
      };
      handle = clock.requestFrame(tick);
      return () => {
        if (handle !== null) clock.cancelFrame(handle);
        handle = null;
      };
    },
    step: () => {
      throw new Error('This clock cannot be stepped: frames follow the display. Install the emulator with clock: "manual" to step them.');
    },
  };
}

/**
 * Creates a source that runs frames only when `step` is called. Frame N of a session has the time N/`framesPerSecond`, so the same script
 * gives the same images.
 */
export function createManualSource(framesPerSecond: number): FrameSource {
  const runs = new Map<(timeS: number) => boolean, number>();
  return {
    manual: true,
    start: (runFrame) => {
      runs.set(runFrame, 0);
      return () => void runs.delete(runFrame);
    },
    step: () => {
      if (runs.size === 0) throw new Error('No session is running, so no frame can be stepped.');
      let drawn = false;
      for (const [run, index] of [...runs]) {
        if (!run(index / framesPerSecond)) continue;
        drawn = true;
        if (runs.has(run)) runs.set(run, index + 1);
      }
      if (!drawn) throw new Error('The session has no layer, so no frame can be drawn. Set a base layer first.');
    },
  };
}
