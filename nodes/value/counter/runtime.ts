import type { NodeContext, NodeRuntime, PulseList } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { up, down, reset } = ctx.inputs;
  const { start, step, cycle } = ctx.params;
  let steps = 0;

  function add(pulses: PulseList, direction: 1 | -1): void {
    const around = Math.floor(cycle.value);
    for (let i = 0; i < pulses.count; i++) {
      steps += direction;
      if (around < 1 || (steps >= 0 && steps < around)) continue;
      steps -= around * Math.floor(steps / around);
      ctx.outputs.around.emit(pulses.at(i));
    }
  }

  return {
    update: () => {
      if (reset.count > 0) steps = 0;
      add(up, 1);
      add(down, -1);
      ctx.outputs.number.value = start.value + steps * step.value;
    },
    reset: () => {
      steps = 0;
    },
    dispose: () => {},
  };
}
