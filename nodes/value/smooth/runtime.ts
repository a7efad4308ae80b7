import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/**
 * Plays the Smooth node. Each frame moves the value by `1 − 2^(−Δt/h)` of its difference from the target: exact for a constant target, so
 * two half steps equal one whole step.
 */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { number, halfLifeS } = ctx.params;
  let at: number | null = null;
  return {
    update: () => {
      const jumps = at === null || ctx.inputs.jump.count > 0 || halfLifeS.value <= 0;
      const part = jumps ? 1 : 1 - 2 ** (-ctx.clock.deltaS / halfLifeS.value);
      const from = at ?? number.value;
      at = part === 1 ? number.value : from + (number.value - from) * part;
      ctx.outputs.result.value = at;
    },
    reset: () => {
      at = null;
    },
    dispose: () => {},
  };
}
