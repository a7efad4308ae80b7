import { defineNode } from '../../kit/definition.ts';
import { BRIGHTNESS_FACTOR, ROTATION_ABOUT_Y } from '../../kit/panorama/params.ts';

export const definition = defineNode({
  type: 'light/environment',
  version: 1,
  title: 'Environment light',
  doc: 'Lights a scene from all sides with a panorama: matte surfaces take on its colors, shiny ones reflect it. It replaces the neutral environment of the Scene node and casts no shadows; for shadows, add a Directional light from where the sun is in the panorama.',
  keywords: ['image-based lighting', 'ibl', 'hdri', 'sky', 'dome', 'reflection', 'surroundings', 'skybox'],
  inputs: {
    environment: { type: 'environment', label: 'Environment', doc: 'The panorama to light with.', required: true },
  },
  outputs: { lights: { type: 'lights', label: 'Light', doc: 'The light, for a Scene node. A scene uses one light of this type.' } },
  params: {
    intensity: {
      ...BRIGHTNESS_FACTOR,
      label: 'Intensity',
      doc: 'Factor on the brightness of the panorama: at 1, a plain white panorama renders a white matte surface as white.',
    },
    rotationRad: {
      ...ROTATION_ABOUT_Y,
      doc: 'Rotates the environment about the vertical axis, counterclockwise seen from above. It adds to the rotation of the Panorama node.',
    },
    visible: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Show behind objects',
      doc: 'Whether the panorama is visible behind the objects of the scene. Otherwise the scene is transparent there.',
      default: false,
    },
  },
  lowering: { kind: 'geometry' },
});
