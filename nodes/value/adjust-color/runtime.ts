import { writeAdjustedColor } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { base, hueRad, saturation, lightness } = ctx.params;
  const color = new Float64Array(4);
  return {
    update: () => {
      writeAdjustedColor(color, base.value, hueRad.value, saturation.value, lightness.value);
      ctx.outputs.color.value = color;
    },
    dispose: () => {},
  };
}
