import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/phantom',
  version: 1,
  title: 'Phantom',
  doc: 'Makes objects stand for real things: they hide what is behind them and can catch and cast shadows, but show no color of their own. Give a box the place and size of a real table, make it a phantom, and a model can go behind the table.',
  keywords: ['occluder', 'invisible', 'mask', 'holdout', 'shadow catcher', 'real', 'floor'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'Shapes in the place of the real things.', required: true, multiple: true },
  },
  outputs: { objects: { type: 'objects', label: 'Phantoms', doc: 'The same objects as phantoms.' } },
  params: {
    castShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Cast shadows',
      doc: 'Whether the real thing casts a shadow on virtual objects. Best left off for floors, over which the shadow map would have to stretch.',
      default: false,
    },
    receiveShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Receive shadows',
      doc: 'Whether virtual objects throw their shadow on the real thing, drawn by a Shadow layer.',
      default: true,
    },
  },
  lowering: { kind: 'geometry' },
});
