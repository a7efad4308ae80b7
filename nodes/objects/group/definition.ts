import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/group',
  version: 1,
  title: 'Group',
  doc: 'Combines several lists of objects into one, in the order of the wires. Use it to transform, mask or draw them together.',
  keywords: ['merge', 'combine', 'join', 'collect', 'list'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to combine.', required: true, multiple: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'All objects, in the order of the wires.' } },
  params: {},
  lowering: { kind: 'geometry' },
});
