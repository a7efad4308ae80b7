import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/make-vector3',
  version: 1,
  title: 'Make vector 3',
  doc: 'Combines three numbers into a vector, such as a position or a size.',
  keywords: ['vector', 'vec3', 'combine', 'join', 'pack', 'compose', 'position', 'xyz'],
  inputs: {},
  outputs: { vector: { type: 'vector3', label: 'Vector', doc: 'The numbers in order.' } },
  params: {
    x: { type: 'number', stage: 'uniform', label: 'X', doc: 'Number 1 of 3.', default: 0 },
    y: { type: 'number', stage: 'uniform', label: 'Y', doc: 'Number 2 of 3.', default: 0 },
    z: { type: 'number', stage: 'uniform', label: 'Z', doc: 'Number 3 of 3.', default: 0 },
  },
  lowering: { kind: 'value' },
});
