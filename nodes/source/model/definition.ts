import { defineNode } from '../../kit/definition.ts';
import { CASTS_SHADOW, RECEIVES_SHADOW } from '../../kit/material-params.ts';

export const definition = defineNode({
  type: 'source/model',
  version: 1,
  title: 'Model',
  doc: 'Loads a 3D model from a glTF file: .glb, or .gltf with its files beside it; Draco, meshopt and KTX2 are supported. The model is in meters, at the origin; use a Transform node to place and scale it. Its animation plays automatically.',
  keywords: ['gltf', 'glb', 'import', 'mesh', 'character', 'animation', '3d'],
  inputs: {},
  outputs: { objects: { type: 'objects', label: 'Object', doc: 'The model; nothing while it loads.' } },
  params: {
    model: { type: 'asset', stage: 'asset', label: 'Model', doc: 'The model file.', default: '', accept: 'model' },
    clip: {
      type: 'text',
      stage: 'structure',
      label: 'Animation',
      doc: 'Name of the animation to play. Empty plays the first one; "none" plays none.',
      default: '',
      animation: { of: 'model' },
    },
    speed: {
      type: 'number',
      stage: 'uniform',
      label: 'Speed',
      doc: 'Playback speed of the animation: 1 is normal, negative plays it backwards.',
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
      doc: 'Off pauses the animation.',
      default: true,
    },
    normals: {
      type: 'choice',
      stage: 'structure',
      label: 'Missing normals',
      doc: 'How meshes are shaded whose file has no normals: each triangle flat, as glTF demands, or smooth across triangles. Meshes with normals do not change.',
      default: 'flat',
      options: [
        { value: 'flat', label: 'Flat' },
        { value: 'smooth', label: 'Smooth' },
      ],
    },
    castShadow: CASTS_SHADOW,
    receiveShadow: RECEIVES_SHADOW,
  },
  lowering: { kind: 'source' },
  stateful: { moves: ['playing', 'speed'] },
});
