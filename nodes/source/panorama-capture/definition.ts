import { defineNode } from '../../kit/definition.ts';
import { PANORAMA_PARAMS } from '../../kit/panorama/params.ts';

export const definition = defineNode({
  type: 'source/panorama-capture',
  version: 1,
  title: 'Capture panorama',
  doc: 'Takes a panorama of the visitor’s room, to find its lamps and to reflect it. Before the page shows anything else, 34 rings appear around the visitor; each turns green when the camera points at it and holds still, which takes a photo. The photos become a panorama, which stays on the device for later visits. Where pages get no camera image, as on glasses, “File” is used.',
  keywords: ['360', 'take', 'photo', 'spheremap', 'hdri', 'room', 'camera', 'stitch', 'environment', 'arpas', 'probe'],
  inputs: {},
  outputs: {
    environment: {
      type: 'environment',
      label: 'Environment',
      doc: 'The panorama, turned as the room is; until one is taken, “File”.',
    },
    pose: {
      type: 'pose',
      label: 'Place',
      doc: 'Where the panorama was taken: −z points to its center. It is invalid until the place is known in this visit.',
    },
  },
  params: {
    file: {
      type: 'asset',
      stage: 'asset',
      label: 'File',
      doc: 'A panorama to use until one is taken, and where none can be taken: in renders, in VR and on displays that give pages no camera image.',
      default: '',
      accept: 'environment',
    },
    size: {
      type: 'choice',
      stage: 'structure',
      label: 'Size',
      doc: 'Width and height of the panorama in pixels. The smaller one is enough for lamps; the larger one for sharp reflections.',
      default: '1024',
      options: [
        { value: '1024', label: '1024 × 512' },
        { value: '2048', label: '2048 × 1024' },
      ],
    },
    ...PANORAMA_PARAMS,
    rotationRad: {
      ...PANORAMA_PARAMS.rotationRad,
      doc: 'Rotates the panorama about the vertical axis, counterclockwise seen from above.',
    },
  },
  needs: [
    {
      capability: 'camera-image',
      required: false,
      when: 'always',
      why: 'to take a panorama of the room, whose light is used',
      without: 'the light is that of another room',
    },
    {
      capability: 'anchors',
      required: false,
      when: 'always',
      why: 'to find the panorama of an earlier visit again',
      without: 'it is found by the camera image',
    },
  ],
  single: true,
  worker: true,
  lowering: { kind: 'source' },
});
