import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'objects/apply-technique',
  version: 1,
  title: 'Apply technique',
  doc: 'Draws objects with a technique instead of their own materials: a cartoon, pen strokes, glass, or one of your own. It keeps their colours, pictures, movement and shadows. Objects that stand in several of these nodes are drawn with the last technique that is for their material. Phantoms stay invisible, and lines and points keep their look.',
  keywords: ['style', 'shader', 'material', 'look', 'override', 'npr', 'toon', 'gooch', 'hatching', 'charcoal', 'glass'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'What to draw with it.', required: true, multiple: true },
    technique: { type: 'technique', label: 'Technique', doc: 'How to draw them.', required: true },
  },
  outputs: { objects: { type: 'objects', label: 'Objects', doc: 'The same objects in their new look.' } },
  params: {
    materials: {
      type: 'text',
      stage: 'structure',
      label: 'Materials',
      doc: 'Names of the materials to draw with it, with commas between them, as the model’s file calls them. Empty means all.',
      default: '',
    },
  },
  lowering: { kind: 'geometry' },
});
