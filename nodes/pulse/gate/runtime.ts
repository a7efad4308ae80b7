import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { pulse } = ctx.inputs;
  return {
    update: () => {
      const out = ctx.params.open.value ? ctx.outputs.passed : ctx.outputs.stopped;
      for (let i = 0; i < pulse.count; i++) out.emit(pulse.at(i));
    },
    dispose: () => {},
  };
}
