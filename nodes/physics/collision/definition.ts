import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'physics/collision',
  version: 1,
  title: 'Collision',
  doc: 'Outputs a pulse when a body begins to touch another body, the floor or the room, with the point, the normal and the strength. Connect it to a sound, a spawn or an impulse.',
  keywords: ['contact', 'hit', 'touch', 'bounce', 'event', 'sound', 'physics'],
  inputs: { body: { type: 'body', label: 'Bodies', doc: 'The bodies to watch.', required: true, multiple: true } },
  outputs: {
    touched: {
      type: 'pulse',
      label: 'Touched',
      doc: 'A pulse per contact, with the body. Its number is the strength in newton seconds; its pose is at the point, with y along the normal towards the body.',
    },
    strength: { type: 'number', label: 'Strength', doc: 'Of the strongest contact of this frame, in newton seconds; 0 without one.' },
  },
  params: {
    leastNs: {
      type: 'number',
      stage: 'uniform',
      label: 'Minimum strength',
      doc: 'Weaker contacts cause no pulse. In newton seconds: 1 kg that stops from 1 m/s has a strength of 1.',
      default: 0.01,
      min: 0,
      max: 1000,
      step: 0.01,
      unit: 'none',
    },
  },
  lowering: { kind: 'behavior' },
});
