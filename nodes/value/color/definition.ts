import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/color',
  version: 1,
  title: 'Color',
  doc: 'Outputs one color. Connect it to several parameters to change them together.',
  keywords: ['color', 'value', 'constant', 'rgb', 'rgba', 'tint'],
  inputs: {},
  outputs: { color: { type: 'color', label: 'Color', doc: 'The color.' } },
  params: { value: { type: 'color', stage: 'uniform', label: 'Value', doc: 'The color to output.', default: [1, 1, 1, 1] } },
  computes: { color: 'value' },
  lowering: { kind: 'value' },
});
