import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/camera-video',
  version: 1,
  title: 'Camera video',
  doc: 'Outputs the image of the device’s camera. As a plain background it needs no camera permission, because an AR device shows the world by itself. The visitor is asked for permission only if a filter reads the image.',
  keywords: ['video', 'camera', 'webcam', 'passthrough', 'world', 'background', 'real'],
  inputs: {},
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The camera image, aligned with the view.', domain: 'view', depth: false },
  },
  params: {
    withoutImage: {
      type: 'choice',
      stage: 'structure',
      label: 'Fallback',
      doc: 'What to show if the device or the visitor does not allow filters to read the camera image.',
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
      doc: 'Color to show without a camera image, if “Fallback” is “A color”.',
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
      why: 'to apply filters to the camera image',
      without: 'The camera image is shown without filters.',
    },
    {
      capability: 'camera-image',
      required: false,
      when: 'sampled',
      where: { param: 'withoutImage', is: 'color' },
      why: 'to apply filters to the camera image',
      without: 'A plain color replaces the camera image.',
    },
  ],
});
