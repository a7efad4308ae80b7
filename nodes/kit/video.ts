import type { ImageAsset } from './runtime.ts';

export interface VideoAsset {
  readonly durationS: number;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Each call makes a playback with a time of its own. `onProblem` is told what hinders it, in words, and what to do. */
  open(onProblem: (problem: { readonly message: string; readonly fix: string }) => void): VideoPlayback;
}

export interface VideoPlayback {
  /** The newest picture that is there; null before the first. */
  readonly picture: ImageAsset | null;
  /**
   * Asks for the picture at `timeS` of the file, in [0, durationS]; every frame. A `rate` above 0 lets the video run on by itself
   * at this speed, `loop` from its end to its start, and puts it right where it strays; 0 asks for exactly this picture.
   */
  follow(timeS: number, rate: number, loop: boolean): void;
  /** As `NodeRuntime.settle`. */
  settle(): Promise<void> | null;
  dispose(): void;
}
