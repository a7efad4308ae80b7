import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/make-vector2',
  version: 1,
  title: 'Make vector 2',
  doc: 'Combines two numbers into a vector, such as a position or a size.',
  keywords: ['vector', 'vec2', 'combine', 'join', 'pack', 'compose', 'position', 'xy'],
  inputs: {},
  outputs: { vector: { type: 'vector2', label: 'Vector', doc: 'The vector of these components.' } },
  params: {
    x: { type: 'number', stage: 'uniform', label: 'X', doc: 'First component.', default: 0 },
    y: { type: 'number', stage: 'uniform', label: 'Y', doc: 'Second component.', default: 0 },
  },
  computes: { vector: '[x, y]' },
  lowering: { kind: 'value' },
});
