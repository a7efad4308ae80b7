import type { Template } from './template.ts';

/** Template of a node that outputs what the visitor does. */
export const INPUT_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Counts the taps of the visitor.',
    keywords: ['touch', 'click'],
    inputs: {},
    outputs: { count: { type: 'number', label: 'Count', doc: 'The number of taps so far.' } },
    params: { start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'Value of the count before the first tap.', default: 0 } },
    lowering: { kind: 'value' },
    // The output depends on the taps of all earlier frames.
    stateful: true,
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  let taps = 0;
  return {
    update: ({ input }) => {
      taps += input.tapCount;
      ctx.outputs.count.value = ctx.params.start.value + taps;
    },
    reset: () => {
      taps = 0;
    },
    dispose: () => {},
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} counts taps, and starts again after a reset', () => {
  const { ctx } = fakeContext(definition, { params: { start: 10 } });
  const node = create(ctx);
  const tap = (tapCount: number): number => {
    node.update({ input: { tapCount } } as SessionFrame);
    return ctx.outputs.count.value;
  };
  expect([tap(0), tap(2), tap(1)]).toEqual([10, 12, 13]);
  node.reset?.();
  expect(tap(0)).toBe(10);
});
`,
  }),
};
