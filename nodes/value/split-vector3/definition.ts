import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-vector3',
  version: 1,
  title: 'Split vector 3',
  doc: 'Splits a vector into its three numbers.',
  keywords: ['vector', 'vec3', 'separate', 'unpack', 'component', 'decompose', 'xyz'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'Number 1 of 3.' },
    y: { type: 'number', label: 'Y', doc: 'Number 2 of 3.' },
    z: { type: 'number', label: 'Z', doc: 'Number 3 of 3.' },
  },
  params: { vector: { type: 'vector3', stage: 'uniform', label: 'Vector', doc: 'The vector to split.', default: [0, 0, 0] } },
  lowering: { kind: 'value' },
});
