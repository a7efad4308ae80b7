import { choiceIndex, choiceOptions } from '../../kit/choice-options.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const options = choiceOptions(ctx.config.options);
  return {
    update: () => {
      const index = choiceIndex(ctx.params.value.value, options.length);
      ctx.outputs.index.value = index;
      ctx.outputs.word.value = options[index] ?? '';
    },
    dispose: () => {},
  };
}
