import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/group',
  version: 1,
  title: 'Group',
  doc: 'Makes one list of objects out of several. Use it to move, mark or draw them together; their order is that of the wires.',
  keywords: ['merge', 'combine', 'join', 'collect', 'list'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to put together.', required: true, multiple: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'All of them, in the order of the wires.' } },
  params: {},
  lowering: { kind: 'geometry' },
});
