import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  let held: number | null = null;
  return {
    update: () => {
      if (ctx.inputs.take.count > 0) held = ctx.params.number.value;
      ctx.outputs.result.value = held ?? ctx.params.start.value;
    },
    reset: () => {
      held = null;
    },
    dispose: () => {},
  };
}
