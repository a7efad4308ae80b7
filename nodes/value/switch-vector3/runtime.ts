import { choiceIndex } from '../../kit/choice-options.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { index, first, second, third, fourth } = ctx.params;
  const choices = [first, second, third, fourth] as const;
  return {
    update: () => {
      ctx.outputs.chosen.value = choices[choiceIndex(index.value, choices.length)]?.value ?? first.value;
    },
    dispose: () => {},
  };
}
