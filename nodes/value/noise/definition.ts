import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/noise',
  version: 1,
  title: 'Noise',
  doc: 'Outputs smooth random values that do not repeat. Connect a Time node to “Along” for flicker, sway or drift. Nearby positions give similar values.',
  keywords: ['perlin', 'random', 'wander', 'drift', 'shake', 'wobble', 'flicker', 'organic', 'turbulence'],
  inputs: {},
  outputs: {
    number: { type: 'number', label: 'Number', doc: 'The noise, from “Low” to “High”.' },
    vector: { type: 'vector3', label: 'Vector', doc: 'Three independent noises, each from “Low” to “High”, to move or rotate an object.' },
  },
  params: {
    along: { type: 'number', stage: 'uniform', label: 'Along', doc: 'Position along the noise. Connect a Time node.', default: 0 },
    place: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Position',
      doc: 'Position in the noise field. Use different fixed positions for several independent noises.',
      default: [0, 0, 0],
    },
    frequency: {
      type: 'number',
      stage: 'uniform',
      label: 'Frequency',
      doc: 'How fast the noise varies: about this many peaks per unit of “Along”.',
      default: 1,
      min: 0,
      max: 100,
      step: 0.1,
    },
    octaves: {
      type: 'number',
      stage: 'structure',
      label: 'Detail',
      doc: 'Number of octaves: each one has half the amplitude and twice the frequency of the one before.',
      default: 1,
      min: 1,
      max: 8,
      step: 1,
    },
    low: { type: 'number', stage: 'uniform', label: 'Low', doc: 'The lowest value.', default: -1 },
    high: { type: 'number', stage: 'uniform', label: 'High', doc: 'The highest value.', default: 1 },
    seed: { type: 'number', stage: 'structure', label: 'Seed', doc: 'Another seed gives another noise.', default: 0, step: 1 },
  },
  lowering: { kind: 'value' },
});
