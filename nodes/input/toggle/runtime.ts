import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  return {
    update: () => {
      ctx.outputs.on.value = ctx.params.value.value;
    },
    dispose: () => {},
  };
}
