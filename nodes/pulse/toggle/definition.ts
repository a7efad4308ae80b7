import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/toggle',
  version: 1,
  title: 'Toggle latch',
  doc: 'Stores a state, on or off, that pulses change. Connect a Button node to “Flip” to switch it by hand.',
  keywords: ['flip-flop', 'flip', 'switch', 'memory', 'boolean', 'on', 'off', 'state', 't flip-flop'],
  inputs: {
    flip: { type: 'pulse', label: 'Flip', doc: 'Each pulse inverts the state. Applied first in a frame.', required: false, multiple: true },
    turnOn: { type: 'pulse', label: 'Turn on', doc: 'Turns it on. Applied after Flip.', required: false, multiple: true },
    turnOff: { type: 'pulse', label: 'Turn off', doc: 'Turns it off. Applied last in a frame.', required: false, multiple: true },
  },
  outputs: { on: { type: 'toggle', label: 'On', doc: 'The current state.' } },
  params: {
    start: { type: 'toggle', stage: 'structure', label: 'Initially on', doc: 'The state before the first pulse.', default: false },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
