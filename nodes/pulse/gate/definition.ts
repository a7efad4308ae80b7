import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/gate',
  version: 1,
  title: 'Gate',
  doc: 'Lets pulses through while it is open, as they are.',
  keywords: ['filter', 'if', 'block', 'allow', 'condition', 'mute', 'pass'],
  inputs: { pulse: { type: 'pulse', label: 'Pulse', doc: 'What to let through.', required: true, multiple: true } },
  outputs: {
    passed: { type: 'pulse', label: 'Passed', doc: 'The pulses that came while it was open.' },
    stopped: { type: 'pulse', label: 'Stopped', doc: 'Those that came while it was shut.' },
  },
  params: {
    open: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Open',
      doc: 'Whether pulses go through. Connect a Compare or a Toggle latch to it.',
      default: true,
    },
  },
  lowering: { kind: 'value' },
});
