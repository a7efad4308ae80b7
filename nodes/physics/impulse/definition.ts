import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'physics/impulse',
  version: 1,
  title: 'Impulse',
  doc: 'Pushes bodies once for each pulse. A pulse that names a body, as those of Collision do, pushes that body alone; another pushes all connected bodies.',
  keywords: ['push', 'kick', 'hit', 'jump', 'force', 'throw', 'physics'],
  inputs: {
    body: { type: 'body', label: 'Bodies', doc: 'The bodies to push.', required: true, multiple: true },
    push: { type: 'pulse', label: 'Push', doc: 'Each pulse is a push.', required: true, multiple: true },
  },
  outputs: {},
  params: {
    impulseNs: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Impulse',
      doc: 'In newton seconds: 1 changes the velocity of 1 kg by 1 m/s.',
      default: [0, 2, 0],
    },
    turnNms: {
      type: 'vector3',
      stage: 'uniform',
      label: 'Angular impulse',
      doc: 'In newton meter seconds, about x, y and z.',
      default: [0, 0, 0],
    },
    axes: {
      type: 'choice',
      stage: 'structure',
      label: 'Axes',
      doc: 'The axes of the impulses. “Pulse”: those of the pose that the pulse carries, whose -z axis points along its ray.',
      default: 'world',
      options: [
        { value: 'world', label: 'World' },
        { value: 'body', label: 'Body' },
        { value: 'pulse', label: 'Pulse' },
      ],
    },
  },
  lowering: { kind: 'behavior' },
  actsOn: 'body',
});
