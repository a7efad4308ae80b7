import type { FrameClock } from '../runtime/clock.ts';

/** Decides when a session's frames happen and what time they carry. One session at a time. */
export interface FrameSource {
  /** `runFrame` is called with seconds until `stop`; it returns whether it really was a frame. */
  start(runFrame: (timeS: number) => boolean): void;
  stop(): void;
  /** Runs one frame now. Only a manual source can. */
  step(): void;
  readonly manual: boolean;
}

/** Frames with the display, carrying its time. */
export function createFreeSource(clock: FrameClock): FrameSource {
  let handle: number | null = null;
  return {
    manual: false,
    start: (runFrame) => {
      const tick = (timeS: number): void => {
        handle = clock.requestFrame(tick);
        runFrame(timeS);
      };
      handle = clock.requestFrame(tick);
    },
    stop: () => {
      if (handle !== null) clock.cancelFrame(handle);
      handle = null;
    },
    step: () => {
      throw new Error('Frames run with the display here. Install the emulator with clock: "manual" to step them.');
    },
  };
}

/** Frame N of a session at N/`framesPerSecond`, whenever `step` is called: the same script gives the same pictures. */
export function createManualSource(framesPerSecond: number): FrameSource {
  let run: ((timeS: number) => boolean) | null = null;
  let index = 0;
  return {
    manual: true,
    start: (runFrame) => {
      run = runFrame;
      index = 0;
    },
    stop: () => {
      run = null;
    },
    step: () => {
      if (!run) throw new Error('There is no session to step.');
      if (!run(index / framesPerSecond)) throw new Error('The session has no base layer yet: nothing can be drawn.');
      index++;
    },
  };
}
