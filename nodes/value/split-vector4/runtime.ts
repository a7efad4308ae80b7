import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { x, y, z, w } = ctx.outputs;
  return {
    update: () => {
      const { value } = ctx.params.vector;
      x.value = value[0] ?? 0;
      y.value = value[1] ?? 0;
      z.value = value[2] ?? 0;
      w.value = value[3] ?? 0;
    },
    dispose: () => {},
  };
}
