import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-number',
  version: 1,
  title: 'Switch numbers',
  doc: 'Outputs one of up to four numbers. Connect a Choice, a Counter or a toggle to “Index”: off is the first, on is the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'number'],
  inputs: {},
  outputs: { chosen: { type: 'number', label: 'Chosen', doc: 'The chosen number.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Index of the chosen one; 0 is the first. It is rounded and limited to the range from the first to the last.',
      default: 0,
      step: 1,
    },
    first: { type: 'number', stage: 'uniform', label: 'First', doc: 'Used at index 0, or off.', default: 0 },
    second: { type: 'number', stage: 'uniform', label: 'Second', doc: 'Used at index 1, or on.', default: 1 },
    third: { type: 'number', stage: 'uniform', label: 'Third', doc: 'Used at index 2.', default: 2 },
    fourth: { type: 'number', stage: 'uniform', label: 'Fourth', doc: 'Used at index 3.', default: 3 },
  },
  computes: { chosen: 'index < 0.5 ? first : index < 1.5 ? second : index < 2.5 ? third : fourth' },
  lowering: { kind: 'value' },
});
