import { type BindingContext, type BoundValue, createWriter } from '../../kit/binding.ts';
import { playExpression } from '../../kit/play-expression.ts';
import type { NodeRuntime } from '../../kit/runtime.ts';

interface Config {
  readonly postfix: string;
  /** The values that the param has without the expression, within its limits. They replace results that are not finite, such as 0 / 0. */
  readonly otherwise: readonly number[];
}

export function create({ outputs, config: made, clock }: BindingContext): NodeRuntime {
  const config = made as unknown as Config;
  const bound = outputs.value as BoundValue;
  const expression = playExpression(config.postfix);
  const otherwise = Float64Array.from(config.otherwise);
  const values = new Float64Array(expression.results.length);
  const write = createWriter(bound, values);
  return {
    update: () => {
      expression.update(clock);
      for (let i = 0; i < values.length; i++) {
        values[i] = expression.results[i] ?? 0;
        if (!Number.isFinite(values[i])) values[i] = otherwise[i] ?? 0;
      }
      write();
    },
    dispose: () => {},
  };
}
