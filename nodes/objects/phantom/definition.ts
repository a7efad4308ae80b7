import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/phantom',
  version: 1,
  title: 'Phantom',
  doc: 'Makes objects stand for real ones: they hide what is behind them and can receive and cast shadows, but are not visible themselves. For example, give a box the position and size of a real table and make it a phantom, so that a model can go behind the table.',
  keywords: ['occluder', 'invisible', 'mask', 'holdout', 'shadow catcher', 'real', 'floor'],
  inputs: {
    objects: {
      type: 'objects',
      label: 'Objects',
      doc: 'Objects with the shapes and positions of the real ones.',
      required: true,
      multiple: true,
    },
  },
  outputs: { objects: { type: 'objects', label: 'Phantoms', doc: 'The same objects as phantoms.' } },
  params: {
    castShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Cast shadows',
      doc: 'Whether the real object casts shadows on virtual ones. Leave it off for floors: the shadow map would have to cover them and lose resolution.',
      default: false,
    },
    receiveShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Receive shadows',
      doc: 'Whether the real object receives shadows of virtual ones. A Shadow node draws them.',
      default: true,
    },
  },
  lowering: { kind: 'geometry' },
});
