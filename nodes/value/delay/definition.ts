import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/delay',
  version: 1,
  title: 'Delay',
  doc: 'Outputs a number as it was some time ago, at least one frame. Use it to close a loop of values: wires may form a loop only through a Delay node, or through a Feedback node for layers.',
  keywords: ['echo', 'lag', 'previous', 'feedback', 'loop', 'history', 'later', 'wait'],
  inputs: {},
  outputs: { result: { type: 'number', label: 'Result', doc: 'The delayed number.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number to delay.', default: 0 },
    delayS: {
      type: 'number',
      stage: 'uniform',
      label: 'Delay',
      doc: 'Delay in seconds; 0 is one frame. Between two frames the value is interpolated linearly.',
      default: 0,
      min: 0,
      max: 10,
      step: 0.05,
      unit: 's',
    },
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'The output until the first delayed number is available.', default: 0 },
  },
  lowering: { kind: 'value' },
  stateful: true,
  delay: true,
});
