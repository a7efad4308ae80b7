import type { Operation } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';

/** Measures the cost of each operation while it draws, for the performance overlay. Exported pages have none. */
export interface OperationTimer {
  begin(operation: Operation): void;
  end(): void;
}

/** One operation that draws. */
export interface Step {
  run(state: PlayState): void;
  /** Present for steps that draw objects: called by `SceneBackend.prepare`. */
  prepare?(state: PlayState): void;
}

export function timed(step: Step, operation: Operation, timer: OperationTimer | null): Step {
  if (timer === null) return step;
  const { run } = step;
  return {
    ...step,
    run: (state) => {
      timer.begin(operation);
      run(state);
      timer.end();
    },
  };
}
