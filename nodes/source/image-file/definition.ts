import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/image-file',
  version: 1,
  title: 'Image file',
  doc: 'A picture from a file, in its own size. Where it meets the view, the node that brings them together says how it fits.',
  keywords: ['picture', 'photo', 'png', 'jpeg', 'webp', 'bitmap', 'texture', 'overlay'],
  inputs: {},
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The picture, transparent until it has loaded.', domain: 'image', depth: false },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The picture to show.', default: '', accept: 'image' },
  },
  lowering: { kind: 'source' },
});
