import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/on-start',
  version: 1,
  title: 'On start',
  doc: 'Outputs one pulse when the project starts to play, or after a delay. It repeats after a reset, but not while you edit the graph.',
  keywords: ['begin', 'init', 'load', 'once', 'trigger', 'bang', 'event', 'after', 'timer'],
  inputs: {},
  outputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The one pulse.' } },
  params: {
    delayS: {
      type: 'number',
      stage: 'uniform',
      label: 'Delay',
      doc: 'Time from the start to the pulse, in seconds.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
