import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/make-vector3',
  version: 1,
  title: 'Make vector 3',
  doc: 'Combines three numbers into a vector, such as a position or a size.',
  keywords: ['vector', 'vec3', 'combine', 'join', 'pack', 'compose', 'position', 'xyz'],
  inputs: {},
  outputs: { vector: { type: 'vector3', label: 'Vector', doc: 'The vector of these components.' } },
  params: {
    x: { type: 'number', stage: 'uniform', label: 'X', doc: 'First component.', default: 0 },
    y: { type: 'number', stage: 'uniform', label: 'Y', doc: 'Second component.', default: 0 },
    z: { type: 'number', stage: 'uniform', label: 'Z', doc: 'Third component.', default: 0 },
  },
  computes: { vector: '[x, y, z]' },
  lowering: { kind: 'value' },
});
