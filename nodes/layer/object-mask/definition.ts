import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/object-mask',
  version: 1,
  title: 'Object mask',
  doc: 'Draws where objects are to be seen: white and opaque there, transparent elsewhere, with depth. Connected to a Mask, it lets a filter touch some objects only, or everything but them. Phantoms, and what is wired to “Hidden by”, cut out what they stand before.',
  keywords: ['matte', 'silhouette', 'stencil', 'selection', 'isolate', 'cut out', 'id', 'holdout'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'What to mask.', required: true, multiple: true },
    hiders: {
      type: 'objects',
      label: 'Hidden by',
      doc: 'Other objects that may stand before them. They leave no white themselves.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    layer: { type: 'layer', label: 'Mask', doc: 'White where the objects are to be seen.', domain: 'view', depth: true },
  },
  params: {
    names: {
      type: 'text',
      stage: 'structure',
      label: 'Names',
      doc: 'Names of the parts to mask, separated by commas, as the model’s file calls them; a part stands for all that hangs on it. The other parts hide them. Empty means everything.',
      default: '',
    },
  },
  lowering: { kind: 'geometry' },
});
