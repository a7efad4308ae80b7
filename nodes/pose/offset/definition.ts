import { defineNode } from '../../kit/definition.ts';
import { ROTATION_PARAM } from '../../kit/pose-params.ts';

export const definition = defineNode({
  type: 'pose/offset',
  version: 1,
  title: 'Offset pose',
  doc: 'Moves and turns a pose in its own space: along and about its own axes. 1 m in front of a Head pose is (0, 0, -1).',
  keywords: ['move', 'turn', 'shift', 'local', 'relative', 'in front', 'attach', 'transform'],
  inputs: { pose: { type: 'pose', label: 'Pose', doc: 'The pose to move.', required: true } },
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The moved pose. Invalid while the input is.' } },
  params: {
    offsetM: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'position',
      label: 'Offset',
      doc: 'How far to move along the axes of the pose.',
      default: [0, 0, 0],
      unit: 'm',
    },
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
  },
  lowering: { kind: 'value' },
});
