import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'light/environment',
  version: 1,
  title: 'Environment light',
  doc: 'Lights a scene from all sides with a panorama: matte surfaces take its colors, shiny ones mirror it. It takes the place of the scene’s neutral surroundings and casts no shadows; add a directional light where the sun stands.',
  keywords: ['image-based lighting', 'ibl', 'hdri', 'sky', 'dome', 'reflection', 'surroundings', 'skybox'],
  inputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama to light with.', required: true },
  },
  outputs: { lights: { type: 'lights', label: 'Light', doc: 'The light, for a Scene layer, which takes one of its kind.' } },
  params: {
    intensity: {
      type: 'number',
      stage: 'uniform',
      label: 'Intensity',
      doc: 'Brightness: at 1 a white matte surface under a sky of plain white is white.',
      default: 1,
      min: 0,
      max: 10,
      step: 0.01,
      unit: 'ratio',
    },
    rotationRad: {
      type: 'number',
      stage: 'uniform',
      label: 'Rotation',
      doc: 'Turns the surroundings about the vertical, to the left seen from above, besides the panorama’s own rotation.',
      default: 0,
      min: -Math.PI,
      max: Math.PI,
      step: 0.01,
      unit: 'rad',
    },
    visible: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Show behind objects',
      doc: 'Whether the panorama itself is seen behind the objects of the scene, instead of what lies under the layer.',
      default: false,
    },
  },
  lowering: { kind: 'geometry' },
});
