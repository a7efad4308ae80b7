import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/counter',
  version: 1,
  title: 'Counter',
  doc: 'Counts pulses, up and down. It can start over after some, and says when it did.',
  keywords: ['count', 'increment', 'add', 'step', 'score', 'index', 'loop', 'sequence'],
  inputs: {
    up: { type: 'pulse', label: 'Up', doc: 'Counts one step up per pulse.', required: false, multiple: true },
    down: { type: 'pulse', label: 'Down', doc: 'Counts one step down per pulse.', required: false, multiple: true },
    reset: {
      type: 'pulse',
      label: 'Reset',
      doc: 'Goes back to the start, before what else comes in the same frame.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    number: { type: 'number', label: 'Number', doc: 'The count.' },
    around: { type: 'pulse', label: 'Around', doc: 'Passes on the pulse that made it start over, in either direction.' },
  },
  params: {
    start: { type: 'number', stage: 'uniform', label: 'Start', doc: 'Where it begins.', default: 0, step: 1 },
    step: { type: 'number', stage: 'uniform', label: 'Step', doc: 'How much a pulse counts.', default: 1, step: 1 },
    cycle: {
      type: 'number',
      stage: 'uniform',
      label: 'Start over after',
      doc: 'How many pulses lead back to the start: with 3 it counts 0, 1, 2, 0. At 0 it goes on for ever.',
      default: 0,
      min: 0,
      step: 1,
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
