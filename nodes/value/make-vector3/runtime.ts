import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { x, y, z } = ctx.params;
  const vector = new Float64Array(3);
  return {
    update: () => {
      vector[0] = x.value;
      vector[1] = y.value;
      vector[2] = z.value;
      ctx.outputs.vector.value = vector;
    },
    dispose: () => {},
  };
}
