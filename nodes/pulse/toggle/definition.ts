import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/toggle',
  version: 1,
  title: 'Toggle latch',
  doc: 'Holds on or off; pulses flip it, turn it on or turn it off. Connect a Button to flip it.',
  keywords: ['flip-flop', 'flip', 'switch', 'memory', 'boolean', 'on', 'off', 'state', 't flip-flop'],
  inputs: {
    flip: { type: 'pulse', label: 'Flip', doc: 'Each pulse flips it. Applied first in a frame.', required: false, multiple: true },
    turnOn: { type: 'pulse', label: 'Turn on', doc: 'Turns it on. Applied after Flip.', required: false, multiple: true },
    turnOff: { type: 'pulse', label: 'Turn off', doc: 'Turns it off. Applied last in a frame.', required: false, multiple: true },
  },
  outputs: { on: { type: 'toggle', label: 'On', doc: 'Whether it is on.' } },
  params: {
    start: { type: 'toggle', stage: 'structure', label: 'On at the start', doc: 'Whether it is on before any pulse.', default: false },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
