import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/camera-video',
  version: 1,
  title: 'Camera video',
  doc: 'What the camera sees. As the background alone it requests no camera access, because the device shows the world by itself; only where a filter reads the picture is the visitor asked for the camera.',
  keywords: ['video', 'camera', 'webcam', 'passthrough', 'world', 'background', 'real'],
  inputs: {},
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The camera picture, as wide as the view.', domain: 'view', depth: false },
  },
  params: {
    withoutImage: {
      type: 'choice',
      stage: 'structure',
      label: 'Fallback',
      doc: 'What to show where the device or the visitor gives no picture to filters.',
      default: 'transparent',
      options: [
        { value: 'transparent', label: 'The world, unfiltered' },
        { value: 'color', label: 'A color' },
      ],
    },
    color: {
      type: 'color',
      stage: 'uniform',
      label: 'Color',
      doc: 'The color to show without a picture, if a color is chosen.',
      default: [0.5, 0.5, 0.5, 1],
    },
  },
  lowering: { kind: 'source', background: 'world' },
  needs: [
    {
      capability: 'camera-image',
      required: 'alone',
      when: 'sampled',
      where: { param: 'withoutImage', is: 'transparent' },
      why: 'to change how the camera picture looks',
      without: 'The camera picture is not changed: the world shows as it is.',
    },
    {
      capability: 'camera-image',
      required: false,
      when: 'sampled',
      where: { param: 'withoutImage', is: 'color' },
      why: 'to change how the camera picture looks',
      without: 'A plain color takes the place of the camera picture.',
    },
  ],
});
