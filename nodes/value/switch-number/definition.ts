import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-number',
  version: 1,
  title: 'Switch numbers',
  doc: 'Chooses one of up to four numbers: by the number of a Choice or a Counter, or by a toggle, where off is the first and on the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'number'],
  inputs: {},
  outputs: { chosen: { type: 'number', label: 'Chosen', doc: 'The chosen number.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Which one: 0 is the first. It is rounded, and those beyond the last one are the last one.',
      default: 0,
      step: 1,
    },
    first: { type: 'number', stage: 'uniform', label: 'First', doc: 'At 0, or off.', default: 0 },
    second: { type: 'number', stage: 'uniform', label: 'Second', doc: 'At 1, or on.', default: 1 },
    third: { type: 'number', stage: 'uniform', label: 'Third', doc: 'At 2.', default: 2 },
    fourth: { type: 'number', stage: 'uniform', label: 'Fourth', doc: 'At 3.', default: 3 },
  },
  lowering: { kind: 'value' },
});
