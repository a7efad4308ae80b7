import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/latch',
  version: 1,
  title: 'Sample & hold',
  doc: 'Samples a number at each pulse and holds it until the next.',
  keywords: ['latch', 'sample and hold', 'hold', 'freeze', 'store', 'remember', 'keep', 'snapshot'],
  inputs: { take: { type: 'pulse', label: 'Take', doc: 'Takes the number as it is now.', required: false, multiple: true } },
  outputs: { result: { type: 'number', label: 'Result', doc: 'The held number.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'What to take.', default: 0 },
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'What it holds before the first pulse.', default: 0 },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
