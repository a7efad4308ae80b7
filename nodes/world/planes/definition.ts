import { defineNode } from '../../kit/definition.ts';
import { SURFACE_CASTS_SHADOW, SURFACE_CATCHES_SHADOW } from '../../kit/surface-params.ts';

export const definition = defineNode({
  type: 'world/planes',
  version: 1,
  title: 'Detected planes',
  doc: 'Gives the flat surfaces of the real room that the device has found, floors, tables and walls, as phantoms: they catch shadows and hide what is behind them. More of them are found while the visitor looks around.',
  keywords: ['plane detection', 'real planes', 'floor', 'wall', 'table', 'ceiling', 'surface', 'shadow catcher', 'phantom', 'real'],
  inputs: {},
  outputs: {
    objects: {
      type: 'objects',
      label: 'Phantoms',
      doc: 'The planes. Wire them to a Shadow layer as what shadows fall on, and to a Scene to hide what is behind them.',
    },
  },
  params: {
    which: {
      type: 'choice',
      stage: 'structure',
      label: 'Orientation',
      doc: 'Floors, tables and ceilings lie level, walls and doors stand upright.',
      default: 'all',
      options: [
        { value: 'all', label: 'All' },
        { value: 'horizontal', label: 'Horizontal' },
        { value: 'vertical', label: 'Vertical' },
      ],
    },
    receiveShadow: SURFACE_CATCHES_SHADOW,
    castShadow: SURFACE_CASTS_SHADOW,
  },
  lowering: { kind: 'geometry' },
  needs: [
    {
      capability: 'planes',
      required: false,
      when: 'always',
      why: 'to let shadows fall on the floor, on tables and on walls',
      without: 'No shadows fall on detected planes; a Shadow layer with room depth wired to it lets them fall on what the depth shows.',
    },
  ],
});
