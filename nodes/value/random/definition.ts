import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/random',
  version: 1,
  title: 'Random',
  doc: 'Outputs a random number and draws a new one at each pulse. A project draws the same numbers every time it plays.',
  keywords: ['chance', 'dice', 'shuffle', 'seed', 'noise', 'arbitrary'],
  inputs: {
    draw: {
      type: 'pulse',
      label: 'Draw',
      doc: 'A pulse draws a new number. Not connected: the first number stays.',
      required: false,
      multiple: true,
    },
  },
  outputs: { number: { type: 'number', label: 'Number', doc: 'The random number.' } },
  params: {
    low: { type: 'number', stage: 'uniform', label: 'Low', doc: 'The lowest possible number.', default: 0 },
    high: {
      type: 'number',
      stage: 'uniform',
      label: 'High',
      doc: 'Upper limit: numbers stay below it; whole numbers include it.',
      default: 1,
    },
    whole: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Whole numbers',
      doc: 'Draw whole numbers only, all with equal probability.',
      default: false,
    },
    seed: { type: 'number', stage: 'structure', label: 'Seed', doc: 'Another seed gives other numbers.', default: 0, step: 1 },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
