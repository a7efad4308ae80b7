import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/random',
  version: 1,
  title: 'Random',
  doc: 'Draws a number by chance, a new one with each pulse. The same project draws the same numbers whenever it runs.',
  keywords: ['chance', 'dice', 'shuffle', 'seed', 'noise', 'arbitrary'],
  inputs: {
    draw: { type: 'pulse', label: 'Draw', doc: 'Draws a new number. Without, it keeps the first.', required: false, multiple: true },
  },
  outputs: { number: { type: 'number', label: 'Number', doc: 'The number drawn.' } },
  params: {
    low: { type: 'number', stage: 'uniform', label: 'Low', doc: 'The least that can come.', default: 0 },
    high: {
      type: 'number',
      stage: 'uniform',
      label: 'High',
      doc: 'Numbers stay below this; of whole numbers it is the most that can come.',
      default: 1,
    },
    whole: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Whole numbers',
      doc: 'Whether only whole numbers come, all equally often.',
      default: false,
    },
    seed: { type: 'number', stage: 'structure', label: 'Seed', doc: 'Another seed draws other numbers.', default: 0, step: 1 },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
