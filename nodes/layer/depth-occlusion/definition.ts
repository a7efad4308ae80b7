import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-occlusion',
  version: 1,
  title: 'Depth occlusion',
  doc: 'Hides the parts of a layer that are behind real surfaces. Where the depth of the layer or of the room is unknown, nothing is hidden. Directly after a Scene node, each transparent object is hidden by its own depth; after filters, by the nearest depth of the pixel.',
  keywords: ['occlude', 'hide', 'behind', 'depth', 'mask', 'real'],
  inputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The layer to occlude. It needs depth.', required: true, encoding: 'either' },
    depth: { type: 'depth', label: 'Room depth', doc: 'Distance to real surfaces.', required: true },
  },
  outputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The parts of the layer that are in front of real surfaces.',
      domain: 'same',
      depth: 'same',
      encoding: 'same',
    },
  },
  params: {
    biasM: {
      type: 'number',
      stage: 'uniform',
      label: 'Depth bias',
      doc: 'How far behind a real surface an object may be and stay visible. Depth sensors have errors of a few centimeters: raise it where real surfaces cut into objects that touch them.',
      default: 0,
      min: 0,
      max: 0.5,
      step: 0.005,
      unit: 'm',
    },
    softnessM: {
      type: 'number',
      stage: 'uniform',
      label: 'Depth softness',
      doc: 'Depth beyond the bias over which the layer fades out. 0 gives a hard edge.',
      default: 0,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'm',
    },
    borderPx: {
      type: 'number',
      stage: 'uniform',
      label: 'Feather',
      doc: 'Width of the soft edge along real objects, in pixels of the view. 0 gives a hard edge; 4 to 8 hide the steps of a coarse sensor.',
      default: 0,
      min: 0,
      max: 32,
      step: 0.5,
      unit: 'px',
    },
  },
  lowering: { kind: 'image', shader: 'layer/depth-occlusion/occlusion.fs', access: 'neighborhood', early: 'occlusion' },
});
