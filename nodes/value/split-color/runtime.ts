import { hsvFromRgb } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { red, green, blue, alpha, hueRad, saturation, brightness } = ctx.outputs;
  const hsv = new Float64Array(3);
  return {
    update: () => {
      const { value } = ctx.params.color;
      red.value = value[0] ?? 0;
      green.value = value[1] ?? 0;
      blue.value = value[2] ?? 0;
      alpha.value = value[3] ?? 0;
      hsvFromRgb(hsv, red.value, green.value, blue.value);
      hueRad.value = (hsv[0] ?? 0) * 2 * Math.PI;
      saturation.value = hsv[1] ?? 0;
      brightness.value = hsv[2] ?? 0;
    },
    dispose: () => {},
  };
}
