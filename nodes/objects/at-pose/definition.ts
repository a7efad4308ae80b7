import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/at-pose',
  version: 1,
  title: 'Place at pose',
  doc: 'Places objects at a pose, such as the result of a Hit test, and hides them while the pose is invalid. The origin of the objects comes to lie on the pose, with its axes along those of the pose; they keep their size.',
  keywords: ['follow', 'attach', 'anchor', 'reticle', 'place', 'put', 'hit test', 'transform', 'pose'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to place.', required: true, multiple: true },
    pose: { type: 'pose', label: 'Pose', doc: 'Where to place them.', required: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The same objects at the pose; none while it is invalid.' } },
  params: {},
  lowering: { kind: 'geometry' },
});
