import { defineNode } from '../../kit/definition.ts';
import { SHADOW_AREA_M, SHADOW_BIAS_PX, SHADOW_FILTER, SHADOW_MAP_SIZE, SHADOW_SOURCE_RAD } from '../../kit/light-params.ts';

export const definition = defineNode({
  type: 'world/light-estimate',
  version: 1,
  title: 'Light estimate',
  doc: 'Lights virtual things as the real room is lit: from all sides, with what shiny surfaces mirror where the device knows it, and from the side of the strongest light, away from which shadows fall. Where the device estimates no light, its brightness and colour are guessed from the camera picture, and where there is none either, it is that of a bright day indoors.',
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
    castShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Cast shadows',
      doc: 'Whether objects throw shadows away from the strongest light.',
      default: true,
    },
    areaM: SHADOW_AREA_M,
    mapSize: SHADOW_MAP_SIZE,
    biasPx: SHADOW_BIAS_PX,
    filter: SHADOW_FILTER,
    sourceRad: SHADOW_SOURCE_RAD,
  },
  lowering: { kind: 'geometry' },
  needs: [
    {
      capability: 'light-estimation',
      required: false,
      when: 'always',
      why: 'to light virtual things as the room is lit',
      without: 'The light is guessed from the camera picture where there is one, or is that of a bright day indoors.',
    },
  ],
});
