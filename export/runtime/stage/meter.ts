import type { Operation } from '../../program/program.ts';
import type { Step } from './step.ts';

/** Looks at operations while they draw, for whoever wants to know what they cost; pages have none. */
export interface Meter {
  begin(operation: Operation): void;
  end(): void;
}

export function metered(step: Step, operation: Operation, meter: Meter | null): Step {
  if (meter === null) return step;
  const { run } = step;
  return {
    ...step,
    run: (state) => {
      meter.begin(operation);
      run(state);
      meter.end();
    },
  };
}
