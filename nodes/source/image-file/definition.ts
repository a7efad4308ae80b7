import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/image-file',
  version: 1,
  title: 'Image file',
  doc: 'Outputs an image from a file, at its own size. The node that combines it with a view scales it to cover the view.',
  keywords: ['picture', 'photo', 'png', 'jpeg', 'webp', 'bitmap', 'texture', 'overlay'],
  inputs: {},
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The image; transparent until it has loaded.', domain: 'image', depth: false },
  },
  params: {
    file: { type: 'asset', stage: 'asset', label: 'File', doc: 'The image file.', default: '', accept: 'image' },
  },
  lowering: { kind: 'source' },
});
