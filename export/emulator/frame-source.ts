import type { FrameClock } from '../runtime/clock.ts';

/** Decides when sessions' frames happen and what time they carry. */
export interface FrameSource {
  /** `runFrame` is called with seconds until what is returned is called; it returns whether it really was a frame. */
  start(runFrame: (timeS: number) => boolean): () => void;
  /** Runs one frame of every session now. Only a manual source can. */
  step(): void;
  readonly manual: boolean;
}

/** Frames with the display, carrying its time. */
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
      throw new Error('Frames run with the display here. Install the emulator with clock: "manual" to step them.');
    },
  };
}

/** Frame N of a session at N/`framesPerSecond`, whenever `step` is called: the same script gives the same pictures. */
export function createManualSource(framesPerSecond: number): FrameSource {
  const runs = new Map<(timeS: number) => boolean, number>();
  return {
    manual: true,
    start: (runFrame) => {
      runs.set(runFrame, 0);
      return () => void runs.delete(runFrame);
    },
    step: () => {
      if (runs.size === 0) throw new Error('There is no session to step.');
      let drawn = false;
      for (const [run, index] of [...runs]) {
        if (!run(index / framesPerSecond)) continue;
        drawn = true;
        if (runs.has(run)) runs.set(run, index + 1);
      }
      if (!drawn) throw new Error('The session has no base layer yet: nothing can be drawn.');
    },
  };
}
