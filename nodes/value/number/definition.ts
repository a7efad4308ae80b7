import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/number',
  version: 1,
  title: 'Number',
  doc: 'One number. Connect it to several params to change them together.',
  keywords: ['value', 'constant', 'float', 'slider', 'scalar'],
  inputs: {},
  outputs: { number: { type: 'number', label: 'Number', doc: 'The number.' } },
  params: { value: { type: 'number', stage: 'uniform', label: 'Value', doc: 'The number to give.', default: 0 } },
  lowering: { kind: 'value' },
});
