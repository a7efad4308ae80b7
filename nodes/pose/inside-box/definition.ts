import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'pose/inside-box',
  version: 1,
  title: 'Inside box',
  doc: 'Tells whether the position of a pose is inside a box, and when it enters and leaves. Connect “Head pose” to react to where the visitor stands.',
  keywords: ['trigger', 'zone', 'volume', 'area', 'region', 'enter', 'leave', 'exit', 'contains', 'collision', 'proximity'],
  inputs: {
    pose: { type: 'pose', label: 'Pose', doc: 'The pose whose position is tested. An invalid pose is outside.', required: true },
    box: {
      type: 'pose',
      label: 'Box',
      doc: 'The center and the axes of the box. Nothing is inside while it is invalid. Without a wire the box is at the origin of world space.',
      required: false,
    },
  },
  outputs: {
    inside: { type: 'toggle', label: 'Inside', doc: 'On while the pose is inside the box.' },
    entered: {
      type: 'pulse',
      label: 'Entered',
      doc: 'A pulse when the pose enters, also if it is inside from the beginning. It carries the pose.',
    },
    left: { type: 'pulse', label: 'Left', doc: 'A pulse when the pose leaves or becomes invalid. It carries the pose if that is valid.' },
  },
  params: {
    sizeM: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Size',
      doc: 'Width, height and depth of the box.',
      default: [1, 1, 1],
      min: [0, 0, 0],
      max: [20, 20, 20],
      unit: 'm',
    },
    marginM: {
      type: 'number',
      stage: 'uniform',
      label: 'Margin',
      doc: 'How far outside of a side a pose has to be to leave. It prevents pulses from noise at the sides.',
      default: 0.02,
      min: 0,
      max: 5,
      step: 0.01,
      unit: 'm',
    },
  },
  lowering: { kind: 'value' },
  stateful: { param: 'marginM', above: 0 },
});
