import { defineNode } from '../../kit/definition.ts';
import { BASE_COLOR, CASTS_SHADOW, METALNESS, RECEIVES_SHADOW, ROUGHNESS } from '../../kit/material-params.ts';

export const definition = defineNode({
  type: 'objects/primitive',
  version: 1,
  title: 'Primitive',
  doc: 'Makes a simple shape at the origin. Use it to block out a scene, to test lights or, as a phantom, to stand for a real object.',
  keywords: ['box', 'cube', 'sphere', 'ball', 'plane', 'floor', 'cylinder', 'cone', 'torus', 'ring', 'shape', 'mesh'],
  inputs: {},
  outputs: { objects: { type: 'objects', label: 'Object', doc: 'The shape.' } },
  params: {
    shape: {
      type: 'choice',
      stage: 'structure',
      label: 'Shape',
      doc: 'The shape. A plane is horizontal and visible from both sides.',
      default: 'box',
      options: [
        { value: 'box', label: 'Box' },
        { value: 'sphere', label: 'Sphere' },
        { value: 'plane', label: 'Plane' },
        { value: 'cylinder', label: 'Cylinder' },
        { value: 'cone', label: 'Cone' },
        { value: 'torus', label: 'Torus' },
      ],
    },
    sizeM: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'scale',
      label: 'Size',
      doc: 'Width, height and depth of the bounding box, in meters. A plane has no height; a torus has a fifth of it.',
      default: [0.3, 0.3, 0.3],
      min: [0, 0, 0],
      max: [5, 5, 5],
      unit: 'm',
    },
    color: { ...BASE_COLOR, default: [0.8, 0.8, 0.8, 1] },
    roughness: ROUGHNESS,
    metalness: METALNESS,
    castShadow: CASTS_SHADOW,
    receiveShadow: RECEIVES_SHADOW,
  },
  lowering: { kind: 'geometry' },
});
