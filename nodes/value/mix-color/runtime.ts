import { writeMixedColor } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { a, b, amount } = ctx.params;
  const { space } = ctx.config;
  const mixed = new Float64Array(4);
  return {
    update: () => {
      writeMixedColor(mixed, a.value, b.value, amount.value, space);
      ctx.outputs.color.value = mixed;
    },
    dispose: () => {},
  };
}
