import { defineNode } from '../../kit/definition.ts';
import { SURFACE_CASTS_SHADOW, SURFACE_CATCHES_SHADOW } from '../../kit/surface-params.ts';

export const definition = defineNode({
  type: 'world/meshes',
  version: 1,
  title: 'Detected meshes',
  doc: 'Outputs the meshes of the real room that the device has scanned, including furniture, as phantoms: they receive shadows and hide what is behind them. Headsets provide meshes; phones provide planes and depth instead.',
  keywords: ['mesh detection', 'real meshes', 'scan', 'room', 'furniture', 'surface', 'shadow catcher', 'phantom', 'real', 'occlusion'],
  inputs: {},
  outputs: {
    objects: {
      type: 'objects',
      label: 'Phantoms',
      doc: 'The meshes. Connect them to “Receivers” of a Shadow node to show shadows on them, and to a Scene node to hide what is behind them.',
    },
  },
  params: {
    receiveShadow: SURFACE_CATCHES_SHADOW,
    castShadow: SURFACE_CASTS_SHADOW,
  },
  lowering: { kind: 'geometry' },
  needs: [
    {
      capability: 'meshes',
      required: false,
      when: 'always',
      why: 'to show shadows on real furniture',
      without: 'No shadows fall on scanned shapes; planes and room depth can take their place.',
    },
  ],
});
