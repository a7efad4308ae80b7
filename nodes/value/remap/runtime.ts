import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { number, fromLow, fromHigh, toLow, toHigh, clamp } = ctx.params;
  const isSmooth = ctx.config.curve === 'smooth';
  return {
    update: () => {
      const span = fromHigh.value - fromLow.value;
      let along = span === 0 ? Number(number.value >= fromLow.value) : (number.value - fromLow.value) / span;
      if (clamp.value || isSmooth) along = Math.min(Math.max(along, 0), 1);
      if (isSmooth) along = along * along * (3 - 2 * along);
      ctx.outputs.result.value = toLow.value + (toHigh.value - toLow.value) * along;
    },
    dispose: () => {},
  };
}
