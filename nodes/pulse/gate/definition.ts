import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/gate',
  version: 1,
  title: 'Gate',
  doc: 'Passes pulses on while it is open and blocks them while it is closed.',
  keywords: ['filter', 'if', 'block', 'allow', 'condition', 'mute', 'pass'],
  inputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'The pulses to pass on.', required: true, multiple: true } },
  outputs: {
    passed: { type: 'pulse', label: 'Passed', doc: 'The pulses that came while it was open.' },
    stopped: { type: 'pulse', label: 'Stopped', doc: 'The pulses that came while it was closed.' },
  },
  params: {
    open: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Open',
      doc: 'Whether pulses pass. Connect a Compare or a Toggle latch node to it.',
      default: true,
    },
  },
  lowering: { kind: 'value' },
});
