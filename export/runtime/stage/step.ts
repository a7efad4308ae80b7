import type { PlayState } from '../play-state.ts';

/** One operation that draws, ready to run. */
export interface Step {
  run(state: PlayState): void;
}
