import { hslFromRgb, rgbFromHsl } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { base, hueRad, saturation, lightness } = ctx.params;
  const color = new Float64Array(4);
  return {
    update: () => {
      const { value } = base;
      hslFromRgb(color, value[0] ?? 0, value[1] ?? 0, value[2] ?? 0);
      const hue = (color[0] ?? 0) + hueRad.value / (2 * Math.PI);
      rgbFromHsl(color, hue, clamp01((color[1] ?? 0) * saturation.value), clamp01((color[2] ?? 0) + lightness.value));
      color[3] = value[3] ?? 1;
      ctx.outputs.color.value = color;
    },
    dispose: () => {},
  };
}

function clamp01(x: number): number {
  return Math.min(Math.max(x, 0), 1);
}
