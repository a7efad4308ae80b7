import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/switch-vector3',
  version: 1,
  title: 'Switch vectors',
  doc: 'Outputs one of up to four vectors. Connect a Choice, a Counter or a toggle to “Index”: off is the first, on is the second.',
  keywords: ['select', 'choose', 'pick', 'if', 'else', 'route', 'index', 'vector'],
  inputs: {},
  outputs: { chosen: { type: 'vector3', label: 'Chosen', doc: 'The chosen vector.' } },
  params: {
    index: {
      type: 'number',
      stage: 'uniform',
      label: 'Index',
      doc: 'Index of the chosen one; 0 is the first. It is rounded and limited to the range from the first to the last.',
      default: 0,
      step: 1,
    },
    first: { type: 'vector3', stage: 'uniform', label: 'First', doc: 'Used at index 0, or off.', default: [0, 0, 0] },
    second: { type: 'vector3', stage: 'uniform', label: 'Second', doc: 'Used at index 1, or on.', default: [0, 0, 0] },
    third: { type: 'vector3', stage: 'uniform', label: 'Third', doc: 'Used at index 2.', default: [0, 0, 0] },
    fourth: { type: 'vector3', stage: 'uniform', label: 'Fourth', doc: 'Used at index 3.', default: [0, 0, 0] },
  },
  computes: { chosen: `[${['x', 'y', 'z'].map(chosenComponent).join(', ')}]` },
  lowering: { kind: 'value' },
});

function chosenComponent(name: string): string {
  return `index < 0.5 ? first.${name} : index < 1.5 ? second.${name} : index < 2.5 ? third.${name} : fourth.${name}`;
}
