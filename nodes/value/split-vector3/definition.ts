import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-vector3',
  version: 1,
  title: 'Split vector 3',
  doc: 'Splits a vector into its three numbers.',
  keywords: ['vector', 'vec3', 'separate', 'unpack', 'component', 'decompose', 'xyz'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'First component.' },
    y: { type: 'number', label: 'Y', doc: 'Second component.' },
    z: { type: 'number', label: 'Z', doc: 'Third component.' },
  },
  params: { vector: { type: 'vector3', stage: 'uniform', label: 'Vector', doc: 'The vector to split.', default: [0, 0, 0] } },
  computes: { x: 'vector.x', y: 'vector.y', z: 'vector.z' },
  lowering: { kind: 'value' },
});
