import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/shadow',
  version: 1,
  title: 'Shadow',
  doc: 'Draws the shadows that objects throw on real things, as a layer of their own: lay it under the Scene layer and over the video. The real things are phantoms.',
  keywords: ['shadow catcher', 'contact', 'ground', 'floor', 'darken'],
  inputs: {
    casters: { type: 'objects', label: 'Objects', doc: 'What throws shadows.', required: true, multiple: true },
    receivers: {
      type: 'objects',
      label: 'Phantoms',
      doc: 'Where they fall. Phantoms alone count, so a group of both will do.',
      required: true,
      multiple: true,
    },
    lights: { type: 'lights', label: 'Lights', doc: 'Lights that the shadows fall away from.', required: true, multiple: true },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The shadow, transparent where light arrives.', domain: 'view', depth: true },
  },
  params: {
    strength: {
      type: 'number',
      stage: 'uniform',
      label: 'Strength',
      doc: 'How dark the shadow is where all light is blocked. Real shadows are lightened by the surroundings: 0.5 suits a bright room.',
      default: 0.5,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    color: { type: 'color', stage: 'uniform', label: 'Colour', doc: 'Colour of the shadow.', default: [0, 0, 0, 1] },
  },
  lowering: { kind: 'geometry', shadowMap: { casters: ['casters'], lights: 'lights' } },
});
