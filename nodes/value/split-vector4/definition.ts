import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-vector4',
  version: 1,
  title: 'Split vector 4',
  doc: 'Splits a vector into its four numbers. A color can be connected too: red, green, blue and alpha.',
  keywords: ['vector', 'vec4', 'separate', 'unpack', 'component', 'decompose', 'xyzw'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'Number 1 of 4.' },
    y: { type: 'number', label: 'Y', doc: 'Number 2 of 4.' },
    z: { type: 'number', label: 'Z', doc: 'Number 3 of 4.' },
    w: { type: 'number', label: 'W', doc: 'Number 4 of 4.' },
  },
  params: { vector: { type: 'vector4', stage: 'uniform', label: 'Vector', doc: 'The vector to split.', default: [0, 0, 0, 0] } },
  lowering: { kind: 'value' },
});
