import { defineNode } from '../../kit/definition.ts';
import { POSITION_PARAM, ROTATION_PARAM, SCALE_PARAM } from '../../kit/pose-params.ts';

export const definition = defineNode({
  type: 'objects/transform',
  version: 1,
  title: 'Transform',
  doc: 'Scales, rotates and then moves objects, all together about the origin. Connect one model to several Transform nodes to show it in several places.',
  keywords: ['move', 'rotate', 'scale', 'position', 'place', 'turn', 'size', 'translate'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to transform.', required: true, multiple: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The transformed objects.' } },
  params: {
    positionM: {
      ...POSITION_PARAM,
      doc: 'Translation in meters: x to the right, y up, z towards the viewer. The floor is at y = 0.',
    },
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
    scale: { ...SCALE_PARAM, doc: 'Uniform scale factor. 0.01 converts a model in centimeters to meters.', min: 0 },
  },
  lowering: { kind: 'geometry' },
});
