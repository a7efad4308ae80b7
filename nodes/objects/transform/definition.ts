import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/transform',
  version: 1,
  title: 'Transform',
  doc: 'Places objects: sizes them, turns them, then moves them, all together about the origin. One model may go through several Transforms and stands in as many places.',
  keywords: ['move', 'rotate', 'scale', 'position', 'place', 'turn', 'size', 'translate'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to place.', required: true, multiple: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The same objects in their new place.' } },
  params: {
    positionM: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Position',
      doc: 'Where to, in metres: x to the right, y up, z towards the viewer. The floor is at y = 0.',
      default: [0, 0, 0],
      min: [-10, -10, -10],
      max: [10, 10, 10],
      unit: 'm',
    },
    rotationRad: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Rotation',
      doc: 'How far to turn about each axis, counter-clockwise seen from its tip: first z (roll), then x (tilt), then y (heading).',
      default: [0, 0, 0],
      min: [-Math.PI, -Math.PI, -Math.PI],
      max: [Math.PI, Math.PI, Math.PI],
      unit: 'rad',
    },
    scale: {
      type: 'number',
      stage: 'uniform',
      label: 'Scale',
      doc: 'Factor on the size, alike in all directions. 0.01 turns a model made in centimetres into metres.',
      default: 1,
      min: 0,
      max: 10,
      step: 0.01,
      unit: 'ratio',
    },
  },
  lowering: { kind: 'geometry' },
});
