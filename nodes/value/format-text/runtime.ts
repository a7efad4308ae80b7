import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { createTextWriter } from '../../kit/text-template.ts';
import type { definition } from './definition.ts';

const NAMES = ['a', 'b', 'c', 'd'] as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { mark, template, decimals } = ctx.config;
  const { result } = ctx.outputs;
  const writer = createTextWriter(template, NAMES, decimals, mark === 'visitor' ? undefined : 'en');
  const numberOf = (name: string): number => ctx.params[name as (typeof NAMES)[number]].value;
  let written: string | null = null;

  if (writer.unknown.length > 0) {
    ctx.report({
      code: 'SCR018',
      severity: 'warning',
      port: 'template',
      message: `The template has a placeholder that is not known: ${writer.unknown.join(' ')}`,
      fix: 'Use {a}, {b}, {c}, {d} or {text}, with decimals and a unit after a colon: {a:2 cm}.',
    });
  }

  return {
    update: () => {
      const { value } = ctx.params.text;
      const numbersChanged = writer.round(numberOf);
      if (!numbersChanged && value === written) return;
      written = value;
      result.value = writer.write(value);
    },
    dispose: () => {},
  };
}
