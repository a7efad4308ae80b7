import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-vector4',
  version: 1,
  title: 'Split vector 4',
  doc: 'Splits a vector into its four numbers. A color can be connected too: red, green, blue and alpha.',
  keywords: ['vector', 'vec4', 'separate', 'unpack', 'component', 'decompose', 'xyzw'],
  inputs: {},
  outputs: {
    x: { type: 'number', label: 'X', doc: 'First component.' },
    y: { type: 'number', label: 'Y', doc: 'Second component.' },
    z: { type: 'number', label: 'Z', doc: 'Third component.' },
    w: { type: 'number', label: 'W', doc: 'Fourth component.' },
  },
  params: { vector: { type: 'vector4', stage: 'uniform', label: 'Vector', doc: 'The vector to split.', default: [0, 0, 0, 0] } },
  computes: { x: 'vector.x', y: 'vector.y', z: 'vector.z', w: 'vector.w' },
  lowering: { kind: 'value' },
});
