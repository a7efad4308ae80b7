import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/make-vector4',
  version: 1,
  title: 'Make vector 4',
  doc: 'Combines four numbers into a vector, such as a position or a size.',
  keywords: ['vector', 'vec4', 'combine', 'join', 'pack', 'compose', 'position', 'xyzw'],
  inputs: {},
  outputs: { vector: { type: 'vector4', label: 'Vector', doc: 'The vector of these components.' } },
  params: {
    x: { type: 'number', stage: 'uniform', label: 'X', doc: 'First component.', default: 0 },
    y: { type: 'number', stage: 'uniform', label: 'Y', doc: 'Second component.', default: 0 },
    z: { type: 'number', stage: 'uniform', label: 'Z', doc: 'Third component.', default: 0 },
    w: { type: 'number', stage: 'uniform', label: 'W', doc: 'Fourth component.', default: 0 },
  },
  computes: { vector: '[x, y, z, w]' },
  lowering: { kind: 'value' },
});
