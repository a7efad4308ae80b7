import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/from-values',
  version: 1,
  title: 'Values to pose',
  doc: 'Makes a pose of a position and a rotation in world space. The pose is always valid.',
  keywords: ['combine', 'position', 'rotation', 'convert', 'pack', 'make', 'vector', 'fixed'],
  inputs: {},
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The pose.' } },
  params: {
    positionM: { type: 'vector3', stage: 'uniform', label: 'Position', doc: 'Position in world space.', default: [0, 0, 0], unit: 'm' },
    rotationRad: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Rotation',
      doc: 'Rotation about each axis, counter-clockwise seen from its tip: first z (roll), then x (pitch), then y (yaw).',
      default: [0, 0, 0],
      min: [-Math.PI, -Math.PI, -Math.PI],
      max: [Math.PI, Math.PI, Math.PI],
      unit: 'rad',
    },
  },
  lowering: { kind: 'value' },
});
