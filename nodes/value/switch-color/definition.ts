import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-color',
  version: 1,
  title: 'Switch colors',
  doc: 'Outputs one of up to four colors. Connect a Choice, a Counter or a toggle to “Index”: off is the first, on is the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'color'],
  inputs: {},
  outputs: { chosen: { type: 'color', label: 'Chosen', doc: 'The chosen color.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Index of the chosen one; 0 is the first. It is rounded and limited to the range from the first to the last.',
      default: 0,
      step: 1,
    },
    first: { type: 'color', stage: 'uniform', label: 'First', doc: 'Used at index 0, or off.', default: [0, 0, 0, 1] },
    second: { type: 'color', stage: 'uniform', label: 'Second', doc: 'Used at index 1, or on.', default: [1, 1, 1, 1] },
    third: { type: 'color', stage: 'uniform', label: 'Third', doc: 'Used at index 2.', default: [0.85, 0.3, 0.2, 1] },
    fourth: { type: 'color', stage: 'uniform', label: 'Fourth', doc: 'Used at index 3.', default: [0.2, 0.45, 0.85, 1] },
  },
  computes: { chosen: `[${['r', 'g', 'b', 'a'].map(chosenComponent).join(', ')}]` },
  lowering: { kind: 'value' },
});

function chosenComponent(name: string): string {
  return `index < 0.5 ? first.${name} : index < 1.5 ? second.${name} : index < 2.5 ? third.${name} : fourth.${name}`;
}
