import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-color',
  version: 1,
  title: 'Switch colors',
  doc: 'Chooses one of up to four colors: by the number of a Choice or a Counter, or by a toggle, where off is the first and on the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'color'],
  inputs: {},
  outputs: { chosen: { type: 'color', label: 'Chosen', doc: 'The chosen color.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Which one: 0 is the first. It is rounded, and those beyond the last one are the last one.',
      default: 0,
      step: 1,
    },
    first: { type: 'color', stage: 'uniform', label: 'First', doc: 'At 0, or off.', default: [0, 0, 0, 1] },
    second: { type: 'color', stage: 'uniform', label: 'Second', doc: 'At 1, or on.', default: [1, 1, 1, 1] },
    third: { type: 'color', stage: 'uniform', label: 'Third', doc: 'At 2.', default: [0.85, 0.3, 0.2, 1] },
    fourth: { type: 'color', stage: 'uniform', label: 'Fourth', doc: 'At 3.', default: [0.2, 0.45, 0.85, 1] },
  },
  lowering: { kind: 'value' },
});
