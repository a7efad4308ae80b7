import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { flip, turnOn, turnOff } = ctx.inputs;
  let on = ctx.config.start;
  return {
    update: () => {
      if (flip.count % 2 === 1) on = !on;
      if (turnOn.count > 0) on = true;
      if (turnOff.count > 0) on = false;
      ctx.outputs.on.value = on;
    },
    reset: () => {
      on = ctx.config.start;
    },
    dispose: () => {},
  };
}
