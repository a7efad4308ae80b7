import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/smooth',
  version: 1,
  title: 'Smooth',
  doc: 'Follows a number softly: each half-life it goes half of the way that is left. The same at any frame rate.',
  keywords: ['ease', 'lag', 'follow', 'damp', 'filter', 'low-pass', 'lowpass', 'exponential', 'slew', 'average'],
  inputs: { jump: { type: 'pulse', label: 'Jump', doc: 'Goes all the way at once.', required: false, multiple: true } },
  outputs: { result: { type: 'number', label: 'Result', doc: 'The softened number.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'What to follow.', default: 0 },
    halfLifeS: {
      type: 'number',
      stage: 'uniform',
      label: 'Half-life',
      doc: 'After how many seconds half of the way is done. 0 follows at once.',
      default: 0.2,
      min: 0,
      step: 0.01,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'halfLifeS', above: 0 },
});
