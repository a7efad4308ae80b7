import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/counter',
  version: 1,
  title: 'Counter',
  doc: 'Counts pulses up and down. It can wrap around after a number of counts and outputs a pulse when it wraps.',
  keywords: ['count', 'increment', 'add', 'step', 'score', 'index', 'loop', 'sequence'],
  inputs: {
    up: { type: 'pulse', label: 'Up', doc: 'Each pulse counts one step up.', required: false, multiple: true },
    down: { type: 'pulse', label: 'Down', doc: 'Each pulse counts one step down.', required: false, multiple: true },
    reset: {
      type: 'pulse',
      label: 'Reset',
      doc: 'Sets the count to “Start”. Applied first in a frame.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    number: { type: 'number', label: 'Number', doc: 'The current count.' },
    around: { type: 'pulse', label: 'Wrapped', doc: 'The pulse that made the count wrap around, in either direction.' },
  },
  params: {
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'The first value of the count.', default: 0, step: 1 },
    step: { type: 'number', stage: 'uniform', label: 'Step', doc: 'How much each pulse adds or subtracts.', default: 1, step: 1 },
    cycle: {
      type: 'number',
      stage: 'uniform',
      label: 'Wrap after',
      doc: 'Number of counts after which it wraps to “Start”: with 3 it counts 0, 1, 2, 0. With 0 it never wraps.',
      default: 0,
      min: 0,
      step: 1,
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
