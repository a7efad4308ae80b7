import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pulse/toggle',
  version: 1,
  title: 'Flip-flop',
  doc: 'Is on or off, and pulses change that: each turns it over, or on, or off. Wire a Button to it for a switch that remembers.',
  keywords: ['toggle', 'flip', 'switch', 'latch', 'memory', 'boolean', 'on', 'off', 'state', 't flip-flop'],
  inputs: {
    flip: { type: 'pulse', label: 'Flip', doc: 'Each pulse turns it over: first of all in a frame.', required: false, multiple: true },
    turnOn: { type: 'pulse', label: 'Turn on', doc: 'Turns it on, whatever it was.', required: false, multiple: true },
    turnOff: { type: 'pulse', label: 'Turn off', doc: 'Turns it off: last of all in a frame.', required: false, multiple: true },
  },
  outputs: { on: { type: 'toggle', label: 'On', doc: 'Whether it is on.' } },
  params: {
    start: { type: 'toggle', stage: 'structure', label: 'On at the start', doc: 'Whether it is on before any pulse.', default: false },
  },
  lowering: { kind: 'value' },
});
