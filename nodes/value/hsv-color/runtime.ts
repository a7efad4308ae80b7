import { rgbFromHsv } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { hueRad, saturation, brightness, alpha } = ctx.params;
  const color = new Float64Array(4);
  return {
    update: () => {
      rgbFromHsv(color, hueRad.value / (2 * Math.PI), clamp01(saturation.value), clamp01(brightness.value));
      color[3] = clamp01(alpha.value);
      ctx.outputs.color.value = color;
    },
    dispose: () => {},
  };
}

function clamp01(x: number): number {
  return Math.min(Math.max(x, 0), 1);
}
