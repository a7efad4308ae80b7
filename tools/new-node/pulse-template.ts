import type { Template } from './template.ts';

/** Template of a node with pulses as input and output. */
export const PULSE_TEMPLATE: Template = {
  definition: (type, title) => ({
    type,
    version: 1,
    title,
    doc: 'Passes on every second pulse.',
    keywords: ['divide', 'skip'],
    inputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The pulses to select from.', required: true, multiple: true } },
    outputs: { passed: { type: 'pulse', label: 'Passed', doc: 'The selected pulses.' } },
    params: {
      every: {
        type: 'number',
        stage: 'uniform',
        label: 'Every',
        doc: 'Passes on one of this many pulses.',
        default: 2,
        min: 1,
        max: 100,
        step: 1,
      },
    },
    lowering: { kind: 'value' },
    // The output depends on the pulses of all earlier frames.
    stateful: true,
  }),
  files: (type, name) => ({
    'runtime.ts': `import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { pulse } = ctx.inputs;
  let count = 0;
  return {
    update: () => {
      for (let i = 0; i < pulse.count; i++) {
        count++;
        if (count < ctx.params.every.value) continue;
        count = 0;
        // A pulse with the number, text and pose of the one passed on.
        ctx.outputs.passed.emit(pulse.at(i));
      }
    },
    reset: () => {
      count = 0;
    },
    dispose: () => {},
  };
}
`,
    [`${name}.test.ts`]: `import { expect, test } from '@jest/globals';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

test('${type} passes on every second pulse, and counts from the start after a reset', () => {
  const pulse = createPulseQueue();
  for (let number = 1; number <= 3; number++) pulse.emit().number = number;
  const { ctx, tick } = fakeContext(definition, { inputs: { pulse } });
  const node = create(ctx);
  node.update({} as never);
  expect(pulseNumbers(ctx.outputs.passed)).toEqual([2]);
  tick(0.1);
  node.update({} as never);
  expect(pulseNumbers(ctx.outputs.passed)).toEqual([1, 3]);
  node.reset?.();
  tick(0.1);
  node.update({} as never);
  expect(pulseNumbers(ctx.outputs.passed)).toEqual([2]);
});
`,
  }),
};
