import { defineNode } from '../../kit/definition.ts';
import { SUN_SHADOW } from '../../kit/light-params.ts';

export const definition = defineNode({
  type: 'world/light-estimate',
  version: 1,
  title: 'Light estimate',
  doc: 'Lights virtual things as the real room is lit: from all sides, with what shiny surfaces mirror where the device knows it, and from the side of the strongest light, away from which shadows fall. Where the device estimates no light, it is that of a bright day indoors; or its brightness and colour are guessed from the camera picture, if the project asks for the camera.',
  keywords: ['ambient', 'real light', 'lighting estimation', 'probe', 'spherical harmonics', 'reflection', 'sun', 'room'],
  inputs: {},
  outputs: { lights: { type: 'lights', label: 'Light', doc: 'The light of the room, for Scene and Shadow layers.' } },
  params: {
    intensity: {
      type: 'number',
      stage: 'uniform',
      label: 'Intensity',
      doc: 'Brightness, as a factor on the light that was found.',
      default: 1,
      min: 0,
      max: 10,
      step: 0.01,
      unit: 'ratio',
    },
    smoothingS: {
      type: 'number',
      stage: 'uniform',
      label: 'Smoothing',
      doc: 'How long the light takes to follow nearly two thirds of a change in the room. Longer is calmer; 0 follows at once.',
      default: 0.5,
      min: 0,
      max: 10,
      step: 0.05,
      unit: 's',
    },
    guessFromCamera: {
      type: 'toggle',
      stage: 'structure',
      label: 'Ask for the camera',
      doc: 'Asks the visitor for the camera, so that brightness and colour can be guessed from its picture where the device estimates no light. Off, they are guessed only where something else in the project asks for the camera.',
      default: false,
    },
    castShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Cast shadows',
      doc: 'Whether objects throw shadows away from the strongest light.',
      default: true,
    },
    ...SUN_SHADOW,
  },
  lowering: { kind: 'geometry' },
  needs: [
    {
      capability: 'light-estimation',
      required: false,
      when: 'always',
      why: 'to light virtual things as the room is lit',
      without: 'The light is guessed from the camera picture where the project asks for the camera, or is that of a bright day indoors.',
    },
    {
      capability: 'camera-image',
      required: false,
      when: 'always',
      where: { param: 'guessFromCamera', is: true },
      why: 'to guess the light of the room from the camera picture',
      without: 'Where the device estimates no light, it is that of a bright day indoors.',
    },
  ],
});
