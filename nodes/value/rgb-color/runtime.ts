import { clamp01 } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { red, green, blue, alpha } = ctx.params;
  const color = new Float64Array(4);
  return {
    update: () => {
      color[0] = clamp01(red.value);
      color[1] = clamp01(green.value);
      color[2] = clamp01(blue.value);
      color[3] = clamp01(alpha.value);
      ctx.outputs.color.value = color;
    },
    dispose: () => {},
  };
}
