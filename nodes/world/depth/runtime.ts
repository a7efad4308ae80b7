import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { views } = ctx.outputs.depth;
  return {
    update: (frame) => {
      for (let i = 0; i < views.length; i++) views[i] = (i < frame.viewCount ? frame.views[i]?.depth : null) ?? null;
    },
    dispose: () => {},
  };
}
