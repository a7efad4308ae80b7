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
  /** Compiles the materials of the step without drawing; present in steps that draw objects, and called within `SceneBackend.prepare`. */
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
