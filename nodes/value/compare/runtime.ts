import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

type Comparison = (difference: number, tolerance: number) => boolean;

const COMPARISONS = {
  greater: (d, t) => d > t,
  'greater-equal': (d, t) => d >= -t,
  less: (d, t) => d < -t,
  'less-equal': (d, t) => d <= t,
  equal: (d, t) => Math.abs(d) <= t,
  'not-equal': (d, t) => Math.abs(d) > t,
} satisfies Record<string, Comparison>;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const compare: Comparison = COMPARISONS[ctx.config.operation];
  const { a, b, tolerance } = ctx.params;
  return {
    update: () => {
      ctx.outputs.result.value = compare(a.value - b.value, Math.max(tolerance.value, 0));
    },
    dispose: () => {},
  };
}
