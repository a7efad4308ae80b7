import type { Operation } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';

/** Follows each operation that draws, for the preview. Exported pages have none. */
export interface OperationMonitor {
  /** Called before an operation draws. The operation draws nothing if this returns false. */
  begin(operation: Operation): boolean;
  end(): void;
}

/** One operation that draws. */
export interface Step {
  run(state: PlayState): void;
  /** Compiles the materials of the step without drawing; present in steps that draw objects, and called within `SceneBackend.prepare`. */
  prepare?(state: PlayState): void;
}

export function monitored(step: Step, operation: Operation, monitor: OperationMonitor | null): Step {
  if (monitor === null) return step;
  const { run } = step;
  return {
    ...step,
    run: (state) => {
      if (monitor.begin(operation)) run(state);
      monitor.end();
    },
  };
}
