import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/on-start',
  version: 1,
  title: 'On start',
  doc: 'Gives one pulse when the picture begins, or some time after. Again after a reset, but not while you go on editing.',
  keywords: ['begin', 'init', 'load', 'once', 'trigger', 'bang', 'event', 'after', 'timer'],
  inputs: {},
  outputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The one pulse.' } },
  params: {
    delayS: {
      type: 'number',
      stage: 'uniform',
      label: 'Delay',
      doc: 'How many seconds after the beginning.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
