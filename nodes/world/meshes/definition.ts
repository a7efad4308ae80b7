import { defineNode } from '../../kit/definition.ts';
import { SURFACE_CASTS_SHADOW, SURFACE_CATCHES_SHADOW } from '../../kit/surface-params.ts';

export const definition = defineNode({
  type: 'world/meshes',
  version: 1,
  title: 'Detected meshes',
  doc: 'Gives the shapes of the real room that the device has scanned, furniture and all, as phantoms: they catch shadows and hide what is behind them. Headsets have them; phones have planes and depth.',
  keywords: ['mesh detection', 'real meshes', 'scan', 'room', 'furniture', 'surface', 'shadow catcher', 'phantom', 'real', 'occlusion'],
  inputs: {},
  outputs: {
    objects: {
      type: 'objects',
      label: 'Phantoms',
      doc: 'The meshes. Wire them to a Shadow layer as what shadows fall on, and to a Scene to hide what is behind them.',
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
      why: 'to let shadows fall on real furniture',
      without: 'No shadows fall on scanned shapes; planes and room depth can take their place.',
    },
  ],
});
