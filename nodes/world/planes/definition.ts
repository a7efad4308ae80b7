import { defineNode } from '../../kit/definition.ts';
import { SURFACE_CASTS_SHADOW, SURFACE_CATCHES_SHADOW } from '../../kit/surface-params.ts';

export const definition = defineNode({
  type: 'world/planes',
  version: 1,
  title: 'Detected planes',
  doc: 'Outputs the flat surfaces that the device has detected in the real room, such as floors, tables and walls, as phantoms: they receive shadows and hide what is behind them. The device detects more of them while the visitor looks around.',
  keywords: ['plane detection', 'real planes', 'floor', 'wall', 'table', 'ceiling', 'surface', 'shadow catcher', 'phantom', 'real'],
  inputs: {},
  outputs: {
    objects: {
      type: 'objects',
      label: 'Phantoms',
      doc: 'The planes. Connect them to “Receivers” of a Shadow node to show shadows on them, and to a Scene node to hide what is behind them.',
    },
  },
  params: {
    which: {
      type: 'choice',
      stage: 'structure',
      label: 'Orientation',
      doc: 'Which planes to output. Floors, tables and ceilings are horizontal; walls and doors are vertical.',
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
      why: 'to show shadows on the floor, tables and walls',
      without: 'No shadows fall on detected planes; a Shadow layer with room depth wired to it lets them fall on what the depth shows.',
    },
  ],
});
