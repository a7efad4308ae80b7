import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/shadow',
  version: 1,
  title: 'Shadow',
  doc: 'Draws only the shadows of objects, as a layer. Use it for shadows of virtual objects on real ones: put it over the camera video and under the Scene layer. Phantoms represent the real objects. If “Objects” includes phantoms, real objects cast shadows too.',
  keywords: ['shadow catcher', 'contact', 'ground', 'floor', 'darken', 'shadow volume', 'shadow map', 'stencil'],
  inputs: {
    casters: { type: 'objects', label: 'Objects', doc: 'The objects that cast shadows.', required: true, multiple: true },
    receivers: {
      type: 'objects',
      label: 'Receivers',
      doc: 'The objects that receive shadows: phantoms, detected planes and meshes. Virtual objects count only if “Receive on” is “Everything”. Optional if room depth is connected.',
      required: false,
      multiple: true,
    },
    depth: {
      type: 'depth',
      label: 'Room depth',
      doc: 'Distance to real surfaces. They receive shadows where there is no receiver; real objects in front of a receiver receive none.',
      required: false,
    },
    lights: { type: 'lights', label: 'Lights', doc: 'The lights that cause the shadows.', required: true, multiple: true },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The shadows; transparent where light arrives.', domain: 'view', depth: true },
  },
  params: {
    strength: {
      type: 'number',
      stage: 'uniform',
      label: 'Strength',
      doc: 'Opacity of the shadow where all light is blocked. Ambient light brightens real shadows: 0.5 suits a bright room.',
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
      doc: 'Used with room depth: how far in front of a receiver a measured depth may be and still count as the receiver. Depth sensors have errors of a few centimeters.',
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
      doc: '“Real objects”: only phantoms receive shadows; put this layer under the Scene layer. “Everything”: virtual objects receive shadows here too; turn off “Shadows” of the Scene node and put this layer over it.',
      default: 'phantoms',
      options: [
        { value: 'phantoms', label: 'Real objects' },
        { value: 'everything', label: 'Everything' },
      ],
    },
    method: {
      type: 'choice',
      stage: 'structure',
      label: 'Method',
      doc: '“Shadow map”: edges are soft, alpha-tested textures cast shadows with holes, and transparent objects dim the light by their alpha. “Shadow volume”: edges are sharp at any distance, transparent objects cast a full shadow or none, the cost grows with the screen area that the volumes cover, and room depth does not receive these shadows but can hide them.',
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
