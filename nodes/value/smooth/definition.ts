import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/smooth',
  version: 1,
  title: 'Smooth',
  doc: 'Follows a number smoothly: in each half-life the remaining difference halves. The result does not depend on the frame rate.',
  keywords: ['ease', 'lag', 'follow', 'damp', 'filter', 'low-pass', 'lowpass', 'exponential', 'slew', 'average'],
  inputs: { jump: { type: 'pulse', label: 'Jump', doc: 'A pulse sets the result to the input at once.', required: false, multiple: true } },
  outputs: { result: { type: 'number', label: 'Result', doc: 'The smoothed number.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The value to follow.', default: 0 },
    halfLifeS: {
      type: 'number',
      stage: 'uniform',
      label: 'Half-life',
      doc: 'Time in which the remaining difference halves, in seconds. 0 follows at once.',
      default: 0.2,
      min: 0,
      step: 0.01,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'halfLifeS', above: 0 },
});
