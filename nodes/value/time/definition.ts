import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'value/time',
  version: 1,
  title: 'Time',
  doc: 'Outputs the seconds since the session began. A change of “Speed” affects only the time after it; the output does not jump.',
  keywords: ['clock', 'seconds', 'animate', 'animation', 'speed', 'loop'],
  inputs: {},
  outputs: { seconds: { type: 'number', label: 'Seconds', doc: 'The time in seconds.' } },
  params: {
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'Factor on the speed of time. A negative speed runs backwards.',
      default: 1,
      step: 0.1,
      unit: 'ratio',
    },
    loopS: {
      type: 'number',
      stage: 'uniform',
      label: 'Wrap after',
      doc: 'Seconds after which the time restarts at 0. With 0 it never restarts.',
      default: 0,
      min: 0,
      step: 0.1,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: { moves: ['speed'] },
});
