import type { PlayState } from '../play-state.ts';

/** One operation that draws, ready to run. */
export interface Step {
  run(state: PlayState): void;
  /** For steps that draw objects: what `SceneBackend.prepare` runs. */
  prepare?(state: PlayState): void;
}
