import type { PlayState } from '../play-state.ts';

/** One operation that draws. */
export interface Step {
  run(state: PlayState): void;
  /** Present for steps that draw objects: called by `SceneBackend.prepare`. */
  prepare?(state: PlayState): void;
}
