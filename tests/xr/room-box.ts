import type { ProjectText } from '../support/project-kit.ts';

/** Half of its width and depth, and its height: meters. */
export const BOX_HALF_M = 0.3;
export const BOX_HEIGHT_M = 0.8;
/** Of the square that stands for the real floor. */
export const FLOOR_HALF_M = 2.5;
export const SHADOW_STRENGTH = 0.6;

/** A box on the floor of the visitor's room: lit as that is, its shadow on the floor, both hidden by what is before them. */
export function roomBox(x: number, z: number): ProjectText {
  return { ...ROOM_BOX, nodes: { ...NODES, 'place-0000': ['objects/transform', { positionM: [x, BOX_HEIGHT_M / 2, z] }] } };
}

const NODES: ProjectText['nodes'] = {
  'box-0000': ['objects/primitive', { sizeM: [2 * BOX_HALF_M, BOX_HEIGHT_M, 2 * BOX_HALF_M], color: [0.9, 0.9, 0.9, 1] }],
  'floor-0000': ['objects/primitive', { shape: 'plane', sizeM: [5, 0, 5] }],
  'real-0000': 'objects/phantom',
  // A map of 2048 pixels, the default, takes most of a frame without a GPU.
  'light-0000': ['world/light-estimate', { smoothingS: 0, mapSize: '512' }],
  'depth-0000': 'world/depth',
  'scene-0000': 'layer/scene',
  'hide-0000': 'layer/depth-occlusion',
  'shadow-0000': ['layer/shadow', { strength: SHADOW_STRENGTH }],
  // Scanned floors are off by centimeters.
  'clip-0000': ['layer/depth-occlusion', { biasM: 0.1 }],
  'over-0000': 'operator/over',
  'screen-0000': 'output/screen',
};

const ROOM_BOX: ProjectText = {
  title: 'A box in the room',
  nodes: NODES,
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
