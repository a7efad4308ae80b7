import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/follow',
  version: 1,
  title: 'Follow',
  doc: 'Follows a pose with a lag: position and rotation approach it exponentially, at any frame rate. It starts at the pose when that becomes valid, and again when it jumps, as at re-centering.',
  keywords: ['lag', 'smooth', 'filter', 'ease', 'damp', 'delay', 'lerp', 'slerp', 'steady', 'stabilize', 'attach'],
  inputs: { pose: { type: 'pose', label: 'Pose', doc: 'The pose to follow.', required: true } },
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The following pose. Invalid while the input is.' } },
  params: {
    timeConstantS: {
      type: 'number',
      stage: 'uniform',
      label: 'Time constant',
      doc: 'Time in which the remaining difference shrinks to 37 % (1 / e), in seconds. 0 follows at once.',
      default: 0.2,
      min: 0,
      max: 10,
      step: 0.01,
      unit: 's',
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'timeConstantS', above: 0 },
});
