import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/spring',
  version: 1,
  title: 'Spring',
  doc: 'Follows a number like a weight on a spring: it can overshoot and swing back. It is stable at any frame rate.',
  keywords: ['bounce', 'elastic', 'wobble', 'oscillate', 'damped', 'follow', 'overshoot', 'physics'],
  inputs: {
    jump: { type: 'pulse', label: 'Jump', doc: 'A pulse sets the result to the input at once, at rest.', required: false, multiple: true },
  },
  outputs: {
    result: { type: 'number', label: 'Result', doc: 'The position of the weight.' },
    speed: { type: 'number', label: 'Speed', doc: 'The speed of the weight, per second.' },
  },
  params: {
    number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number that the spring pulls to.', default: 0 },
    frequencyHz: {
      type: 'number',
      stage: 'uniform',
      label: 'Frequency',
      doc: 'Swings per second without damping. A higher frequency is a stiffer spring.',
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
      doc: 'How fast the swinging stops: 0 never, 1 is the fastest without overshoot, more is slower.',
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
