import type { Template } from './template.ts';

/** Template of a node that computes a function of numbers. */
export const VALUE_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Multiplies a number by a factor.',
    keywords: ['multiply'],
    inputs: {},
    outputs: { result: { type: 'number', label: 'Result', doc: 'The product.' } },
    params: {
      number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number to multiply.', default: 1 },
      factor: { type: 'number', stage: 'uniform', label: 'Factor', doc: 'The factor.', default: 2, min: 0, max: 10 },
    },
    lowering: { kind: 'value' },
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { number, factor } = ctx.params;
  return {
    update: () => {
      ctx.outputs.result.value = number.value * factor.value;
    },
    dispose: () => {},
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} multiplies, and follows its params', () => {
  const { ctx, set } = fakeContext(definition, { params: { number: 3 } });
  const node = create(ctx);
  node.update({} as never);
  expect(ctx.outputs.result.value).toBe(6);
  set('factor', 0.5);
  node.update({} as never);
  expect(ctx.outputs.result.value).toBe(1.5);
});
`,
  }),
};
