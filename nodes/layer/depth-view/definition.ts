import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/depth-view',
  version: 1,
  title: 'Depth view',
  doc: 'Shows room depth as colors, to check what the sensor measures: red is near, blue is far, dark stripes are unknown. A scale shows the distances in meters.',
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
      doc: 'Distance that is shown as red. Nearer surfaces are red too.',
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
      doc: 'Distance that is shown as blue. Farther surfaces are blue too. Phones measure up to about 8 m.',
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
      doc: 'Opacity of the colors: 0 is transparent, 1 is opaque.',
      default: 1,
      min: 0,
      max: 1,
      step: 0.01,
      unit: 'ratio',
    },
    legend: { type: 'toggle', stage: 'uniform', label: 'Scale', doc: 'Show the scale of colors and distances.', default: true },
  },
  lowering: { kind: 'image', shader: 'layer/depth-view/depth-view.fs', access: 'pointwise' },
});
