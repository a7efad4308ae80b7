import type { ProjectText } from '../support/project-kit.ts';

/** A box on the floor: metres. */
export const BOX_M = { min: [-0.5, 0, -0.5], max: [0.5, 0.9, 0.5] } as const;
/** Of the square that stands for the real floor. */
export const FLOOR_HALF_M = 2.5;
export const SHADOW_STRENGTH = 0.6;

/** The box in the visitor's room: lit as that is, its shadow on the floor, both hidden by what is before them. */
export const ROOM_BOX: ProjectText = {
  title: 'A box in the room',
  nodes: {
    'box-0000': ['objects/primitive', { sizeM: [1, 0.9, 1], color: [0.9, 0.9, 0.9, 1] }],
    'place-0000': ['objects/transform', { positionM: [0, 0.45, 0] }],
    'floor-0000': ['objects/primitive', { shape: 'plane', sizeM: [5, 0, 5] }],
    'real-0000': 'objects/phantom',
    'light-0000': ['world/light-estimate', { smoothingS: 0 }],
    'depth-0000': 'world/depth',
    'scene-0000': 'layer/scene',
    'hide-0000': 'layer/depth-occlusion',
    'shadow-0000': ['layer/shadow', { strength: SHADOW_STRENGTH }],
    // Scanned floors are off by centimetres.
    'clip-0000': ['layer/depth-occlusion', { biasM: 0.1 }],
    'over-0000': 'operator/over',
    'screen-0000': 'output/screen',
  },
  wires: [
    'box-0000.objects -> place-0000.objects',
    'place-0000.objects -> scene-0000.objects',
    'light-0000.lights -> scene-0000.lights',
    'scene-0000.layer -> hide-0000.layer',
    'depth-0000.depth -> hide-0000.depth',
    'floor-0000.objects -> real-0000.objects',
    'place-0000.objects -> shadow-0000.casters',
    'real-0000.objects -> shadow-0000.receivers',
    'light-0000.lights -> shadow-0000.lights',
    'shadow-0000.layer -> clip-0000.layer',
    'depth-0000.depth -> clip-0000.depth',
    'hide-0000.layer -> over-0000.top',
    'clip-0000.layer -> over-0000.bottom',
    'over-0000.layer -> screen-0000.layer',
  ],
};
