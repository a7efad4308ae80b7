import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/noise',
  version: 1,
  title: 'Noise',
  doc: 'Wanders smoothly and without repeating: wire Time to it for flicker, sway or drift. With a position as well, neighbors wander alike.',
  keywords: ['perlin', 'random', 'wander', 'drift', 'shake', 'wobble', 'flicker', 'organic', 'turbulence'],
  inputs: {},
  outputs: {
    number: { type: 'number', label: 'Number', doc: 'The noise at that place, between its ends.' },
    vector: { type: 'vector3', label: 'Vector', doc: 'Three noises side by side, each between the ends: to move or turn something.' },
  },
  params: {
    along: { type: 'number', stage: 'uniform', label: 'Along', doc: 'How far along the noise: wire Time to it.', default: 0 },
    place: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Position',
      doc: 'Where in space: a fixed one sets several noises apart.',
      default: [0, 0, 0],
    },
    frequency: {
      type: 'number',
      stage: 'uniform',
      label: 'Frequency',
      doc: 'How fast it wanders: about so many hills per step along.',
      default: 1,
      min: 0,
      max: 100,
      step: 0.1,
    },
    octaves: {
      type: 'number',
      stage: 'structure',
      label: 'Detail',
      doc: 'How many noises, each half as large and twice as fast as the one before, are laid over each other.',
      default: 1,
      min: 1,
      max: 8,
      step: 1,
    },
    low: { type: 'number', stage: 'uniform', label: 'Low', doc: 'The least it gets.', default: -1 },
    high: { type: 'number', stage: 'uniform', label: 'High', doc: 'The most it gets.', default: 1 },
    seed: { type: 'number', stage: 'structure', label: 'Seed', doc: 'Another seed wanders elsewhere.', default: 0, step: 1 },
  },
  lowering: { kind: 'value' },
});
