import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/smooth-vector3',
  version: 1,
  title: 'Smooth vector',
  doc: 'Follows a vector smoothly: in each half-life the remaining distance halves. Connect “Point” of a Tap node to it and the result to a position, to make objects glide to where the visitor taps.',
  keywords: ['ease', 'lag', 'follow', 'damp', 'filter', 'glide', 'position', 'exponential', 'average'],
  inputs: { jump: { type: 'pulse', label: 'Jump', doc: 'A pulse sets the result to the input at once.', required: false, multiple: true } },
  outputs: { result: { type: 'vector3', label: 'Result', doc: 'The smoothed vector.' } },
  params: {
    vector: { type: 'vector3', stage: 'uniform', label: 'Vector', doc: 'The value to follow.', default: [0, 0, 0] },
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
