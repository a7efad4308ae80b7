import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/number',
  version: 1,
  title: 'Number',
  doc: 'Outputs one number. Connect it to several parameters to change them together.',
  keywords: ['value', 'constant', 'float', 'slider', 'scalar'],
  inputs: {},
  outputs: { number: { type: 'number', label: 'Number', doc: 'The number.' } },
  params: { value: { type: 'number', stage: 'uniform', label: 'Value', doc: 'The number to output.', default: 0 } },
  computes: { number: 'value' },
  lowering: { kind: 'value' },
});
