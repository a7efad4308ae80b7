import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/shadow',
  version: 1,
  title: 'Shadow',
  doc: 'Draws the shadows that objects throw, as a layer of their own. Those on real things lie under the Scene layer and over the video; the real things are phantoms. With phantoms among its objects too, real things cast shadows as well.',
  keywords: ['shadow catcher', 'contact', 'ground', 'floor', 'darken', 'shadow volume', 'shadow map', 'stencil'],
  inputs: {
    casters: { type: 'objects', label: 'Objects', doc: 'What casts shadows.', required: true, multiple: true },
    receivers: {
      type: 'objects',
      label: 'Receivers',
      doc: 'Where they fall: phantoms, real planes and meshes. Only phantoms count, unless “Receive on” is Everything. Optional if room depth is connected.',
      required: false,
      multiple: true,
    },
    depth: {
      type: 'depth',
      label: 'Room depth',
      doc: 'How far away the real room is. Shadows fall on what it shows where no receiver is, but not on real objects in front of a receiver.',
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
    color: { type: 'color', stage: 'uniform', label: 'Color', doc: 'Color of the shadow.', default: [0, 0, 0, 1] },
    toleranceM: {
      type: 'number',
      stage: 'uniform',
      label: 'Tolerance',
      doc: 'With room depth wired: how far before a surface the depth may show something and still count as the surface itself. Sensors are off by a few centimeters.',
      default: 0.05,
      min: 0,
      max: 0.5,
      step: 0.005,
      unit: 'm',
    },
    on: {
      type: 'choice',
      stage: 'structure',
      label: 'Receive on',
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
      doc: 'Shadow map: edges are a little soft, holes that a picture cuts let light through, and transparent objects dim it by their alpha. Shadow volume: edges are sharp at any distance, and transparent objects cast a full shadow or none; it costs the more, the more of the picture lies behind objects, and does not fall on what room depth shows, which only cuts it off.',
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
