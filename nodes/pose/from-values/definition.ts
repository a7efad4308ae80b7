import { defineNode } from '../../kit/definition.ts';
import { ROTATION_PARAM } from '../../kit/pose-params.ts';

export const definition = defineNode({
  type: 'pose/from-values',
  version: 1,
  title: 'Values to pose',
  doc: 'Makes a pose of a position and a rotation in world space. The pose is always valid.',
  keywords: ['combine', 'position', 'rotation', 'convert', 'pack', 'make', 'vector', 'fixed'],
  inputs: {},
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The pose.' } },
  params: {
    positionM: {
      type: 'vector3',
      stage: 'uniform',
      handle: 'position',
      label: 'Position',
      doc: 'Position in world space.',
      default: [0, 0, 0],
      unit: 'm',
    },
    rotationRad: { ...ROTATION_PARAM, handle: 'rotation' },
  },
  lowering: { kind: 'value' },
});
