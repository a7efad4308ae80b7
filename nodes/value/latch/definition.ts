import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/latch',
  version: 1,
  title: 'Sample & hold',
  doc: 'Samples a number at each pulse and holds it until the next.',
  keywords: ['latch', 'sample and hold', 'hold', 'freeze', 'store', 'remember', 'keep', 'snapshot'],
  inputs: { take: { type: 'pulse', label: 'Take', doc: 'A pulse samples the number.', required: false, multiple: true } },
  outputs: { result: { type: 'number', label: 'Result', doc: 'The held number.' } },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number to sample.', default: 0 },
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'The output before the first pulse.', default: 0 },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
