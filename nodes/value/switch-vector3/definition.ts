import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-vector3',
  version: 1,
  title: 'Switch vectors',
  doc: 'Chooses one of up to four vectors: by the number of a Choice or a Counter, or by a toggle, where off is the first and on the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'vector'],
  inputs: {},
  outputs: { chosen: { type: 'vector3', label: 'Chosen', doc: 'The chosen vector.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Which one: 0 is the first. It is rounded, and those beyond the last one are the last one.',
      default: 0,
      step: 1,
    },
    first: { type: 'vector3', stage: 'uniform', label: 'First', doc: 'At 0, or off.', default: [0, 0, 0] },
    second: { type: 'vector3', stage: 'uniform', label: 'Second', doc: 'At 1, or on.', default: [0, 0, 0] },
    third: { type: 'vector3', stage: 'uniform', label: 'Third', doc: 'At 2.', default: [0, 0, 0] },
    fourth: { type: 'vector3', stage: 'uniform', label: 'Fourth', doc: 'At 3.', default: [0, 0, 0] },
  },
  lowering: { kind: 'value' },
});
