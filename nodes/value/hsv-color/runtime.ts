import { writeHsvColor } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { hueRad, saturation, brightness, alpha } = ctx.params;
  const color = new Float64Array(4);
  return {
    update: () => {
      writeHsvColor(color, hueRad.value, saturation.value, brightness.value, alpha.value);
      ctx.outputs.color.value = color;
    },
    dispose: () => {},
  };
}
