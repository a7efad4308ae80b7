import { defineNode } from '../../kit/definition.ts';

export const definition = defineNode({
  type: 'layer/object-mask',
  version: 1,
  title: 'Object mask',
  doc: 'Makes a mask of objects: white and opaque where they are visible, transparent elsewhere, with depth. Connect it to a Mask or Matte node to apply a filter to these objects only, or to everything else. Phantoms and the objects of “Hidden by” cut out the parts that they cover.',
  keywords: ['matte', 'silhouette', 'stencil', 'selection', 'isolate', 'cut out', 'id', 'holdout'],
  inputs: {
    objects: { type: 'objects', label: 'Objects', doc: 'The objects to mask.', required: true, multiple: true },
    hiders: {
      type: 'objects',
      label: 'Hidden by',
      doc: 'Objects that may cover the masked ones. They are not part of the mask.',
      required: false,
      multiple: true,
    },
  },
  outputs: {
    layer: { type: 'layer', label: 'Mask', doc: 'White where the objects are visible.', domain: 'view', depth: true },
  },
  params: {
    names: {
      type: 'text',
      stage: 'structure',
      label: 'Names',
      doc: 'Names of the nodes of the model to mask, as in its file, separated by commas. Children are included. The other parts can cover them. Empty masks everything.',
      default: '',
    },
  },
  lowering: { kind: 'geometry' },
});
