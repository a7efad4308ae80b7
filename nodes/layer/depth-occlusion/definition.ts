import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-occlusion',
  version: 1,
  title: 'Depth occlusion',
  doc: 'Hides what of a layer lies behind the real room. Where the depth of the layer or of the room is not known, nothing is hidden. Right after a Scene, transparent objects and what is behind them are each hidden by their own depth; after filters, by the nearest depth.',
  keywords: ['occlude', 'hide', 'behind', 'depth', 'mask', 'real'],
  inputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The layer to hide parts of, with depth.', required: true },
    depth: { type: 'depth', label: 'Room depth', doc: 'How far away the real room is.', required: true },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'What of the layer lies before the room.', domain: 'same', depth: 'same' },
  },
  params: {
    biasM: {
      type: 'number',
      stage: 'uniform',
      label: 'Depth bias',
      doc: 'How far behind a real surface something may lie and still show. Sensors are off by a few centimeters: where real surfaces eat into things that touch them, raise it to that.',
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
      doc: 'Over how much more depth it fades away. 0 is a hard border.',
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
      doc: 'How wide the soft border is along real things, in pixels of the view. 0 is a hard border; 4 to 8 hide the steps of a coarse sensor.',
      default: 0,
      min: 0,
      max: 32,
      step: 0.5,
      unit: 'px',
    },
  },
  lowering: { kind: 'image', shader: 'layer/depth-occlusion/occlusion.fs', access: 'neighborhood', early: 'occlusion' },
});
