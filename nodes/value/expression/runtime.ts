import { playExpression } from '../../kit/play-expression.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

/** Plays the Expression node. `config.expression` is the expression in postfix notation, which the compiler writes. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const expression = playExpression(ctx.config.expression, ctx.params);
  const { result } = ctx.outputs;
  return {
    update: () => {
      expression.update(ctx.clock);
      const computed = expression.results[0] ?? 0;
      result.value = Number.isFinite(computed) ? computed : 0;
    },
    dispose: () => {},
  };
}
