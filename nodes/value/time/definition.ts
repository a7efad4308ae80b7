import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/time',
  version: 1,
  title: 'Time',
  doc: 'Seconds since the session began. Changing the speed while it runs changes how fast time goes on, not where it is.',
  keywords: ['clock', 'seconds', 'animate', 'animation', 'speed', 'loop'],
  inputs: {},
  outputs: { seconds: { type: 'number', label: 'Seconds', doc: 'The time, seconds.' } },
  params: {
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'How many seconds pass in a second. Negative runs backwards.',
      default: 1,
      step: 0.1,
      unit: 'ratio',
    },
    loopS: {
      type: 'number',
      stage: 'uniform',
      label: 'Start over after',
      doc: 'Seconds after which time begins anew at 0. 0 is never.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: { moves: ['speed'] },
});
