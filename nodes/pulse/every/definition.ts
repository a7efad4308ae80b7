import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/every',
  version: 1,
  title: 'Interval',
  doc: 'Outputs pulses at a fixed interval, independent of the frame rate. Pulses are numbered from 1.',
  keywords: ['metronome', 'timer', 'every', 'clock', 'beat', 'tempo', 'repeat', 'trigger', 'bang'],
  inputs: {},
  outputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The pulses.' } },
  params: {
    periodS: {
      type: 'number',
      stage: 'uniform',
      label: 'Interval',
      doc: 'Time between two pulses, in seconds. With 0 there are no pulses.',
      default: 1,
      min: 0,
      step: 0.05,
      unit: 's',
    },
    atOnce: {
      type: 'toggle',
      stage: 'structure',
      label: 'Start at once',
      doc: 'Whether the first pulse comes at the start; otherwise it comes after one interval.',
      default: false,
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
