import { linearFromOklab, linearFromSrgb, oklabFromLinear, srgbFromLinear } from '../../kit/color-math.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Mixes premultiplied colors, as CSS Color 4 §12.3, so that a transparent color does not contribute. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { a, b, amount } = ctx.params;
  const { space } = ctx.config;
  const from = new Float64Array(3);
  const to = new Float64Array(3);
  const mixed = new Float64Array(4);

  function enter(out: Float64Array, color: Readonly<Float64Array>): void {
    for (let i = 0; i < 3; i++) out[i] = space === 'screen' ? (color[i] ?? 0) : linearFromSrgb(color[i] ?? 0);
    if (space === 'perceived') oklabFromLinear(out, out[0] ?? 0, out[1] ?? 0, out[2] ?? 0);
  }

  return {
    update: () => {
      enter(from, a.value);
      enter(to, b.value);
      const part = Math.min(Math.max(amount.value, 0), 1);
      const alphaA = (a.value[3] ?? 1) * (1 - part);
      const alphaB = (b.value[3] ?? 1) * part;
      const alpha = alphaA + alphaB;
      // Between two fully transparent colors, mix the channels: a later node may make them opaque.
      const weightB = alpha === 0 ? part : alphaB / alpha;
      for (let i = 0; i < 3; i++) mixed[i] = (from[i] ?? 0) * (1 - weightB) + (to[i] ?? 0) * weightB;
      if (space === 'perceived') linearFromOklab(mixed, mixed[0] ?? 0, mixed[1] ?? 0, mixed[2] ?? 0);
      for (let i = 0; i < 3; i++) {
        const channel = Math.min(Math.max(mixed[i] ?? 0, 0), 1);
        mixed[i] = space === 'screen' ? channel : srgbFromLinear(channel);
      }
      mixed[3] = alpha;
      ctx.outputs.color.value = mixed;
    },
    dispose: () => {},
  };
}
