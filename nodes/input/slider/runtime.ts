import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { min, max } = ctx.config;
  const least = Math.min(min, max);
  const most = Math.max(min, max);
  return {
    update: () => {
      ctx.outputs.number.value = Math.min(Math.max(ctx.params.value.value, least), most);
    },
    dispose: () => {},
  };
}
