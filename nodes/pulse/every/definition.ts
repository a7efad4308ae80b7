import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/every',
  version: 1,
  title: 'Every',
  doc: 'Gives pulses in equal times: as many whatever the frame rate. The number of a pulse says which it is, from 1.',
  keywords: ['metronome', 'timer', 'interval', 'clock', 'beat', 'tempo', 'repeat', 'trigger', 'bang'],
  inputs: {},
  outputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The pulses.' } },
  params: {
    periodS: {
      type: 'number',
      stage: 'uniform',
      label: 'Every',
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
});
