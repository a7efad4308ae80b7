import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/smooth-vector3',
  version: 1,
  title: 'Smooth vector',
  doc: 'Follows a position or another vector softly: each half-life it goes half of the way that is left. Wire a Tap’s point through it, and things glide there.',
  keywords: ['ease', 'lag', 'follow', 'damp', 'filter', 'glide', 'position', 'exponential', 'average'],
  inputs: { jump: { type: 'pulse', label: 'Jump', doc: 'Goes all the way at once.', required: false, multiple: true } },
  outputs: { result: { type: 'vector3', label: 'Result', doc: 'The softened vector.' } },
  params: {
    vector: { type: 'vector3', stage: 'uniform', label: 'Vector', doc: 'What to follow.', default: [0, 0, 0] },
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
