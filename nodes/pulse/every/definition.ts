import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/every',
  version: 1,
  title: 'Interval',
  doc: 'Outputs a pulse at a fixed interval, whatever the frame rate. Pulses are numbered from 1.',
  keywords: ['metronome', 'timer', 'every', 'clock', 'beat', 'tempo', 'repeat', 'trigger', 'bang'],
  inputs: {},
  outputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The pulses.' } },
  params: {
    periodS: {
      type: 'number',
      stage: 'uniform',
      label: 'Interval',
      doc: 'Seconds between two pulses. 0 gives none.',
      default: 1,
      min: 0,
      step: 0.05,
      unit: 's',
    },
    atOnce: {
      type: 'toggle',
      stage: 'structure',
      label: 'At once',
      doc: 'Whether the first one comes at the very beginning.',
      default: false,
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
