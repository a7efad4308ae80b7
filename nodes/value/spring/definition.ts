import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/spring',
  version: 1,
  title: 'Spring',
  doc: 'Follows a number like a weight on a spring: it may swing beyond and come back. It stays calm however long a frame takes.',
  keywords: ['bounce', 'elastic', 'wobble', 'oscillate', 'damped', 'follow', 'overshoot', 'physics'],
  inputs: { jump: { type: 'pulse', label: 'Jump', doc: 'Puts it to rest at its number at once.', required: false, multiple: true } },
  outputs: {
    result: { type: 'number', label: 'Result', doc: 'Where the weight is.' },
    speed: { type: 'number', label: 'Speed', doc: 'How fast it moves, per second.' },
  },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'Where the spring pulls to.', default: 0 },
    frequencyHz: {
      type: 'number',
      stage: 'uniform',
      label: 'Frequency',
      doc: 'How many times a second it would swing without damping. Higher is stiffer.',
      default: 2,
      min: 0.01,
      max: 30,
      step: 0.1,
      unit: 'Hz',
    },
    damping: {
      type: 'number',
      stage: 'uniform',
      label: 'Damping',
      doc: 'How soon it comes to rest: 0 swings for ever, 1 is the fastest way without going beyond, more is sluggish.',
      default: 0.3,
      min: 0,
      max: 5,
      step: 0.05,
      unit: 'ratio',
    },
  },
  lowering: { kind: 'value' },
  stateful: true,
});
