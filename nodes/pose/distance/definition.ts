import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/distance',
  version: 1,
  title: 'Distance',
  doc: 'Gives the distance between two poses, and its level and vertical parts. Connect “Head pose” to react to how near the visitor is. The numbers are 0 while one of both poses is invalid.',
  keywords: ['length', 'proximity', 'near', 'far', 'range', 'height', 'gap', 'between', 'measure'],
  inputs: {
    from: { type: 'pose', label: 'From', doc: 'The first pose. Its rotation does not matter.', required: true },
    to: { type: 'pose', label: 'To', doc: 'The second pose. Its rotation does not matter.', required: true },
  },
  outputs: {
    distanceM: { type: 'number', label: 'Distance', doc: 'The straight distance, meters.' },
    levelM: { type: 'number', label: 'Level distance', doc: 'The distance without the difference in height, meters.' },
    heightM: { type: 'number', label: 'Height', doc: 'How much higher “To” is than “From”, meters; negative where it is lower.' },
    valid: { type: 'toggle', label: 'Valid', doc: 'On while both poses are valid.' },
  },
  params: {},
  lowering: { kind: 'value' },
});
