import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/to-values',
  version: 1,
  title: 'Pose to values',
  doc: 'Splits a pose into its position and the direction that it faces. Connect them to parameters of other nodes.',
  keywords: ['split', 'position', 'direction', 'forward', 'convert', 'unpack', 'vector', 'xyz'],
  inputs: { pose: { type: 'pose', label: 'Pose', doc: 'The pose.', required: true } },
  outputs: {
    position: { type: 'vector3', label: 'Position', doc: 'Meters, world space. The origin while the pose is invalid.' },
    forward: {
      type: 'vector3',
      label: 'Forward',
      doc: 'The -z axis of the pose, a unit vector in world space. (0, 0, -1) while the pose is invalid.',
    },
    valid: { type: 'toggle', label: 'Valid', doc: 'On while the pose is valid.' },
  },
  params: {},
  lowering: { kind: 'value' },
});
