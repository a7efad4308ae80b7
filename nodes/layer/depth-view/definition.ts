import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-view',
  version: 1,
  title: 'Depth view',
  doc: 'Shows the room’s depth in colors, to see what the sensor sees: red is near, blue is far, and dark stripes are unknown. A scale beside it says the meters.',
  keywords: ['debug', 'color map', 'heat map', 'distance', 'legend', 'sensor', 'false color'],
  inputs: {
    depth: { type: 'depth', label: 'Room depth', doc: 'The depth to show.', required: true },
  },
  outputs: {
    layer: { type: 'layer', label: 'Layer', doc: 'The depth in colors.', domain: 'view', depth: false },
  },
  params: {
    nearM: {
      type: 'number',
      stage: 'uniform',
      label: 'Red distance',
      doc: 'What is nearer is red, too.',
      default: 0.5,
      min: 0,
      max: 20,
      step: 0.1,
      unit: 'm',
    },
    farM: {
      type: 'number',
      stage: 'uniform',
      label: 'Blue distance',
      doc: 'What is farther is blue, too. Phones measure up to about 8 m.',
      default: 4,
      min: 0.1,
      max: 20,
      step: 0.1,
      unit: 'm',
    },
    opacity: {
      type: 'number',
      stage: 'uniform',
      label: 'Opacity',
      doc: 'Below 1, what lies under it shows through.',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    legend: { type: 'toggle', stage: 'uniform', label: 'Scale', doc: 'Shows which color stands for how many meters.', default: true },
  },
  lowering: { kind: 'image', shader: 'layer/depth-view/depth-view.fs', access: 'pointwise' },
});
