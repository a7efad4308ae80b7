import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { number, least } = ctx.params;
  const { direction } = ctx.config;
  /**
   * The value from which changes are measured: that of the last pulse, or the farthest value in the other direction since. Null before the
   * first frame.
   */
  let from: number | null = null;
  return {
    update: () => {
      const now = number.value;
      from ??= now;
      const way = now - from;
      if (way === 0) return;
      const counts = direction === 'changes' || (direction === 'rises' ? way > 0 : way < 0);
      if (counts && Math.abs(way) < least.value) return;
      from = now;
      if (counts) ctx.outputs.changed.emit().number = now;
    },
    reset: () => {
      from = null;
    },
    dispose: () => {},
  };
}
