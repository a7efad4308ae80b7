import type { ProjectText } from './project-kit.ts';

type Place = readonly [x: number, y: number, z: number];

export interface GlassBall {
  readonly ballM: number;
  readonly ballAt?: Place;
  readonly boxM: number;
  readonly boxAt: Place;
  readonly roughness?: number;
  /** Whether the room hides both. */
  readonly isInRoom?: boolean;
}

/** A ball of glass before a red box, over the camera image. */
export function glassBallBeforeBox({ ballM, ballAt = [0, 0, 0], boxM, boxAt, roughness = 0, isInRoom = false }: GlassBall): ProjectText {
  return {
    title: 'A ball of glass',
    nodes: {
      'video-a1': 'source/camera-video',
      'ball-a1': ['objects/primitive', { shape: 'sphere', sizeM: [ballM, ballM, ballM] }],
      'place-a1': ['objects/transform', { positionM: ballAt }],
      'box-a1': ['objects/primitive', { shape: 'box', sizeM: [boxM, boxM, boxM], color: [1, 0, 0, 1] }],
      'back-a1': ['objects/transform', { positionM: boxAt }],
      'glass-a1': ['technique/glass', { thicknessM: ballM, roughness }],
      'clear-a1': 'objects/apply-technique',
      'sun-b2': ['light/directional', { castShadow: false }],
      'scene-c3': ['layer/scene', { shadows: false }],
      ...(isInRoom && { 'depth-c3': 'world/depth', 'hide-c3': 'layer/depth-occlusion' }),
      'over-c3': 'operator/over',
      'screen-d4': 'output/screen',
    },
    wires: [
      'ball-a1.objects -> place-a1.objects',
      'place-a1.objects -> clear-a1.objects',
      'glass-a1.technique -> clear-a1.technique',
      'video-a1.layer -> glass-a1.behind',
      'box-a1.objects -> back-a1.objects',
      'clear-a1.objects -> scene-c3.objects',
      'back-a1.objects -> scene-c3.objects',
      'sun-b2.lights -> scene-c3.lights',
      ...(isInRoom
        ? ['scene-c3.layer -> hide-c3.layer', 'depth-c3.depth -> hide-c3.depth', 'hide-c3.layer -> over-c3.top']
        : ['scene-c3.layer -> over-c3.top']),
      'video-a1.layer -> over-c3.bottom',
      'over-c3.layer -> screen-d4.layer',
    ],
  };
}
