import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/split-vector2',
  version: 1,
  title: 'Split vector 2',
  doc: 'Splits a vector into its two numbers.',
  keywords: ['vector', 'vec2', 'separate', 'unpack', 'component', 'decompose', 'xy'],
  inputs: {},
  outputs: { x: { type: 'number', label: 'X', doc: 'First component.' }, y: { type: 'number', label: 'Y', doc: 'Second component.' } },
  params: { vector: { type: 'vector2', stage: 'uniform', label: 'Vector', doc: 'The vector to split.', default: [0, 0] } },
  computes: { x: 'vector.x', y: 'vector.y' },
  lowering: { kind: 'value' },
});
