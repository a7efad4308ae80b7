import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/apply-technique',
  version: 1,
  title: 'Set material',
  doc: 'Replaces the materials of objects with a custom material: toon, hatching, glass, or one of your own. Colors, textures, animation and shadows are kept. If an object passes through several of these nodes, the last one that matches its material applies. Phantoms stay invisible; lines and points keep their materials.',
  keywords: ['apply technique', 'style', 'shader', 'look', 'override', 'npr', 'toon', 'gooch', 'hatching', 'charcoal', 'glass'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to draw with the material.', required: true, multiple: true },
    technique: { type: 'technique', label: 'Material', doc: 'The material to draw them with.', required: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The same objects with the new material.' } },
  params: {
    materials: {
      type: 'text',
      stage: 'structure',
      label: 'Replace',
      doc: 'Names of the materials to replace, as in the model’s file, separated by commas. Empty means all.',
      default: '',
    },
  },
  lowering: { kind: 'geometry' },
});
