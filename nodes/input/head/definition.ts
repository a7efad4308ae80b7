import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'input/head',
  version: 1,
  title: 'Head pose',
  doc: 'Gives the pose of the viewer: the camera of a phone or page, or the middle between the eyes in a headset. It faces along -z.',
  keywords: ['camera', 'eye', 'gaze', 'headset', 'player', 'position', 'phone', 'user'],
  inputs: {},
  outputs: { pose: { type: 'pose', label: 'Pose', doc: 'The viewer. Invalid in a frame without a view.' } },
  params: {},
  lowering: { kind: 'value' },
});
