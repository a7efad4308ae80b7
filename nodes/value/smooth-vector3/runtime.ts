import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Smooths each component as `value/smooth` does: by `1 − 2^(−Δt/h)` of its difference from the target. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { vector, halfLifeS } = ctx.params;
  const at = new Float64Array(3);
  let begun = false;
  return {
    update: () => {
      const jumps = !begun || ctx.inputs.jump.count > 0 || halfLifeS.value <= 0;
      const part = jumps ? 1 : 1 - 2 ** (-ctx.clock.deltaS / halfLifeS.value);
      for (let i = 0; i < 3; i++) {
        const from = at[i] ?? 0;
        const to = vector.value[i] ?? 0;
        at[i] = part === 1 ? to : from + (to - from) * part;
      }
      begun = true;
      ctx.outputs.result.value = at;
    },
    reset: () => {
      begun = false;
    },
    dispose: () => {},
  };
}
