import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-mask',
  version: 1,
  title: 'Depth mask',
  doc: 'Makes a mask of distance: white where what is seen lies within a range, black elsewhere and where the distance is not known. It looks at the depth of a layer, at that of the real room, or at whichever is nearer.',
  keywords: ['range', 'distance', 'near', 'far', 'matte', 'slice', 'depth key', 'focus'],
  inputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'Whose depth counts. Without it, the room’s alone does.', required: false },
    depth: {
      type: 'depth',
      label: 'Room depth',
      doc: 'How far away the real room is. Without it, the layer’s alone counts.',
      required: false,
    },
  },
  outputs: {
    layer: { type: 'layer', label: 'Mask', doc: 'White within the range.', domain: 'view', depth: false },
  },
  params: {
    nearM: {
      type: 'number',
      stage: 'uniform',
      label: 'From',
      doc: 'Where the range begins, meters from the eye.',
      default: 0.5,
      min: 0,
      max: 20,
      step: 0.05,
      unit: 'm',
    },
    farM: {
      type: 'number',
      stage: 'uniform',
      label: 'To',
      doc: 'Where it ends.',
      default: 1.5,
      min: 0,
      max: 20,
      step: 0.05,
      unit: 'm',
    },
    softnessM: {
      type: 'number',
      stage: 'uniform',
      label: 'Softness',
      doc: 'Over how much more distance on either side white becomes black. 0 is a hard edge.',
      default: 0.1,
      min: 0,
      max: 5,
      step: 0.05,
      unit: 'm',
    },
    invert: { type: 'toggle', stage: 'uniform', label: 'Invert', doc: 'Swaps black and white.', default: false },
  },
  lowering: { kind: 'image', shader: 'layer/depth-mask/depth-mask.fs', access: 'pointwise' },
});
