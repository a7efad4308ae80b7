import { CAMERA_SCALE, FLOOR_M, placesOf, type RoomPlan, SHADOW_AREA_M, SPACING_M } from './pages/room-plan.ts';

export const MODEL_FILE = 'AntiqueCamera.glb';

/**
 * A project that draws the plan: one model node per model, or one model node and an Array node. The light estimate lights the models, they
 * cast shadows on the real floor, and room depth hides them, as far as the plan says.
 */
export function roomProject({ count, occlusion, shadow, shadowMapPx, filter, plainDepth, copies }: RoomPlan): object {
  const nodes: Record<string, object> = {
    'every-0000': node('objects/group'),
    'floor-0000': node('objects/primitive', { shape: 'plane', sizeM: [FLOOR_M[0], 0, FLOOR_M[1]] }),
    'real-0000': node('objects/phantom'),
    'light-0000': node('world/light-estimate', {
      smoothingS: 0,
      areaM: SHADOW_AREA_M,
      mapSize: String(shadowMapPx),
      castShadow: shadow,
      filter,
    }),
    'scene-0000': node('layer/scene'),
    'shadow-0000': node('layer/shadow', { strength: 0.55 }),
    'over-0000': node('operator/over'),
    'depth-0000': { ...node('world/depth', plainDepth ? { filter: 'nearest', fillHoles: false } : {}), version: 2 },
    'hide-0000': node('layer/depth-occlusion'),
    'screen-0000': node('output/screen'),
  };
  const wires = [
    'every-0000.objects -> scene-0000.objects',
    'light-0000.lights -> scene-0000.lights',
    'floor-0000.objects -> real-0000.objects',
    'every-0000.objects -> shadow-0000.casters',
    'real-0000.objects -> shadow-0000.receivers',
    'light-0000.lights -> shadow-0000.lights',
    ...(occlusion ? ['scene-0000.layer -> hide-0000.layer', 'depth-0000.depth -> hide-0000.depth'] : []),
  ];
  const drawn = occlusion ? 'hide-0000.layer' : 'scene-0000.layer';
  if (shadow) wires.push(`${drawn} -> over-0000.top`, 'shadow-0000.layer -> over-0000.bottom', 'over-0000.layer -> screen-0000.layer');
  else wires.push(`${drawn} -> screen-0000.layer`);
  if (copies) {
    nodes['copies-0000'] = node('objects/copies', { pattern: 'grid', count, stepM: [SPACING_M, 0, SPACING_M] });
    wires.push('place-0000.objects -> copies-0000.objects', 'copies-0000.objects -> every-0000.objects');
  }
  placesOf(copies ? 1 : count).forEach((positionM, i) => {
    const name = String(i).padStart(4, '0');
    nodes[`model-${name}`] = node('source/model', { model: 'camera', playing: false });
    nodes[`place-${name}`] = node('objects/transform', { positionM, scale: CAMERA_SCALE });
    wires.push(`model-${name}.objects -> place-${name}.objects`);
    if (!copies) wires.push(`place-${name}.objects -> every-0000.objects`);
  });
  return {
    format: 'scrim-project',
    version: 1,
    title: 'A room with cameras',
    graphs: { main: { nodes, wires } },
    assets: { camera: { path: `assets/${MODEL_FILE}`, kind: 'model' } },
  };
}

function node(type: string, params: object = {}): object {
  return { type, version: 1, params };
}
