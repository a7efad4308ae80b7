import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'source/model',
  version: 1,
  title: 'Model',
  doc: 'Brings in a 3D model: a glTF file (.glb, or a .gltf with its files beside it; Draco, meshopt and KTX2 are read), in meters, standing at the origin. Its animations play by themselves; a Transform places and sizes it.',
  keywords: ['gltf', 'glb', 'import', 'mesh', 'character', 'animation', '3d'],
  inputs: {},
  outputs: { objects: { type: 'objects', label: 'Object', doc: 'The model; nothing while it loads.' } },
  params: {
    model: { type: 'asset', stage: 'asset', label: 'Model', doc: 'The model file.', default: '', accept: 'model' },
    clip: {
      type: 'text',
      stage: 'structure',
      label: 'Animation',
      doc: 'Name of the animation to play. Empty for the first one, "none" for the model at rest.',
      default: '',
    },
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'How fast the animation runs: 1 as made, negative backwards.',
      default: 1,
      min: -4,
      max: 4,
      step: 0.01,
      unit: 'ratio',
    },
    playing: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Playing',
      doc: 'Off holds the animation where it is.',
      default: true,
    },
    castShadow: { type: 'toggle', stage: 'uniform', label: 'Cast shadows', doc: 'Whether it casts a shadow.', default: true },
    receiveShadow: {
      type: 'toggle',
      stage: 'uniform',
      label: 'Receive shadows',
      doc: 'Whether it receives shadows, its own included.',
      default: true,
    },
  },
  lowering: { kind: 'source' },
  stateful: { moves: ['playing', 'speed'] },
});
