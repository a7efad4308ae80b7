import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-mask',
  version: 1,
  title: 'Depth mask',
  doc: 'Makes a mask from distance: white where the distance is within a range, black elsewhere and where the distance is unknown. It reads the depth of a layer, the depth of the room, or the nearer of both.',
  keywords: ['range', 'distance', 'near', 'far', 'matte', 'slice', 'depth key', 'focus'],
  inputs: {
    layer: {
      type: 'layer',
      label: 'Layer',
      doc: 'The layer whose depth is read. Not connected: only room depth is read.',
      required: false,
    },
    depth: {
      type: 'depth',
      label: 'Room depth',
      doc: 'Distance to real surfaces. Not connected: only the depth of the layer is read.',
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
      doc: 'Start of the range, in meters from the camera.',
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
      doc: 'End of the range, in meters from the camera.',
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
      doc: 'Distance beyond each end of the range over which white fades to black. 0 gives a hard edge.',
      default: 0.1,
      min: 0,
      max: 5,
      step: 0.05,
      unit: 'm',
    },
    invert: { type: 'toggle', stage: 'uniform', label: 'Invert', doc: 'Swap black and white.', default: false },
  },
  lowering: { kind: 'image', shader: 'layer/depth-mask/depth-mask.fs', access: 'pointwise' },
});
