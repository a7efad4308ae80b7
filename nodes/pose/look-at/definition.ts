import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/look-at',
  version: 1,
  title: 'Look at',
  doc: 'Turns a pose towards another one, with y up; its position stays. Connect “Head pose” as the target to make objects face the visitor. A target straight above or below keeps the x axis; a target at the same position keeps the rotation.',
  keywords: ['face', 'turn', 'aim', 'billboard', 'towards', 'camera', 'orient', 'target'],
  inputs: {
    pose: { type: 'pose', label: 'Pose', doc: 'The pose to turn.', required: true },
    target: { type: 'pose', label: 'Target', doc: 'Where it turns to. Its rotation does not matter.', required: true },
  },
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The turned pose. Invalid while one of both is invalid.' } },
  params: {
    front: {
      type: 'choice',
      stage: 'structure',
      label: 'Front',
      doc: 'The axis that points at the target.',
      default: 'z',
      options: [
        { value: 'z', label: '+z, as of models' },
        { value: '-z', label: '-z, as of rays and cameras' },
      ],
    },
    upright: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Upright',
      doc: 'Turns about the vertical axis alone: y stays vertical.',
      default: false,
    },
  },
  lowering: { kind: 'value' },
});
