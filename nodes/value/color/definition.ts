import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/color',
  version: 1,
  title: 'Colour',
  doc: 'One colour. Wire it to several params to change them together.',
  keywords: ['color', 'value', 'constant', 'rgb', 'rgba', 'tint'],
  inputs: {},
  outputs: { color: { type: 'color', label: 'Colour', doc: 'The colour.' } },
  params: { value: { type: 'color', stage: 'uniform', label: 'Value', doc: 'The colour to give.', default: [1, 1, 1, 1] } },
  lowering: { kind: 'value' },
});
