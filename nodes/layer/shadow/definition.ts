import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/shadow',
  version: 1,
  title: 'Shadow',
  doc: 'Draws the shadows that objects throw, as a layer of their own. Those on real things lie under the Scene layer and over the video; the real things are phantoms. With phantoms among its objects too, real things throw shadows as well.',
  keywords: ['shadow catcher', 'contact', 'ground', 'floor', 'darken', 'shadow volume', 'shadow map', 'stencil'],
  inputs: {
    casters: { type: 'objects', label: 'Objects', doc: 'What throws shadows.', required: true, multiple: true },
    receivers: {
      type: 'objects',
      label: 'Falls on',
      doc: 'Where they fall: phantoms, real planes and meshes. Phantoms alone count unless “On” says otherwise, so a group of both will do. May be left out where room depth is wired.',
      required: false,
      multiple: true,
    },
    depth: {
      type: 'depth',
      label: 'Room depth',
      doc: 'How far away the real room is. Shadows fall on what it shows where nothing of “Falls on” is, and none lies on real things that stand before what catches it.',
      required: false,
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
    toleranceM: {
      type: 'number',
      stage: 'uniform',
      label: 'Tolerance',
      doc: 'With room depth wired: how far before a surface the depth may show something and still count as the surface itself. Sensors are off by a few centimetres.',
      default: 0.05,
      min: 0,
      max: 0.5,
      step: 0.005,
      unit: 'm',
    },
    on: {
      type: 'choice',
      stage: 'structure',
      label: 'On',
      doc: 'Real things: phantoms alone; lay the shadow under the Scene layer. Everything: virtual objects catch shadows here too; turn “Shadows” off at the Scene layer, and lay the shadow over it.',
      default: 'phantoms',
      options: [
        { value: 'phantoms', label: 'Real things' },
        { value: 'everything', label: 'Everything' },
      ],
    },
    method: {
      type: 'choice',
      stage: 'structure',
      label: 'Method',
      doc: 'Shadow map: edges are a little soft, holes that a picture cuts let light through, and what is see-through dims it by its alpha. Shadow volume: edges are sharp at any distance, and what is see-through casts a full shadow or none; it costs the more, the more of the picture lies behind objects, and does not fall on what room depth shows, which only cuts it off.',
      default: 'map',
      options: [
        { value: 'map', label: 'Shadow map' },
        { value: 'volume', label: 'Shadow volume' },
      ],
    },
  },
  lowering: {
    kind: 'geometry',
    shadowMap: { casters: ['casters'], lights: 'lights', chosenBy: { param: 'method', value: 'map' } },
  },
});
