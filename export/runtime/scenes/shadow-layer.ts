import type { DrawnScene } from '../../../nodes/kit/runtime.ts';
import type { ObjectItem } from '../../../nodes/kit/scene-lists.ts';
import type { ShadowCatcherLook } from '../../../nodes/kit/scene-look.ts';
import type { DrawBinding } from '../scene-backend.ts';
import { createLightLimits, createTextureLimits } from './lights/light-limits.ts';
import type { MapLimits } from './lights/light-map.ts';
import type { RenderedShadowMaps } from './lights/shadow-maps.ts';
import type { OcclusionPatch } from './materials/occlusion-patch.ts';
import { createRoomSurface } from './materials/room-surface.ts';
import { createMapCatcher } from './materials/shadow-catcher.ts';
import type { SceneRenderer } from './scene-renderer.ts';
import { createShadowScene } from './shadow-scene.ts';
import { createVolumeCatcher } from './volumes/volume-catcher.ts';
import type { VolumeLimits } from './volumes/volume-set.ts';

export interface ShadowLayerOptions {
  readonly renderer: SceneRenderer;
  readonly look: ShadowCatcherLook;
  readonly maps: RenderedShadowMaps | null;
  readonly occlusion: OcclusionPatch | null;
  readonly limits: MapLimits;
  readonly report: DrawBinding['report'];
}

/** Creates the scene of a shadow layer: with shadow maps or shadow volumes, as its look says. Only this function depends on that choice. */
export function createShadowLayer({ renderer, look, maps, occlusion, limits, report }: ShadowLayerOptions): DrawnScene {
  const { strength, color, volumesOf, room, glow = null, strokes = null } = look;
  const catches = (item: ObjectItem): boolean => look.on === 'everything' || item.role === 'phantom';
  const surface = room ? createRoomSurface(room.depth, room.toleranceM) : null;
  const shared = { strength, color, occlusion: [occlusion, surface?.clip ?? null].filter((patch) => patch !== null) };
  if (!volumesOf) {
    const catcher = createMapCatcher({ ...shared, glow, strokes, maps, textureLimits: createTextureLimits(report) });
    return createShadowScene({ renderer, catcher, catches, occlusion, surface, watchLimits: createLightLimits(report, 'shadows', limits) });
  }
  const catcher = createVolumeCatcher({ ...shared, renderer, casters: volumesOf, catches, limits: createVolumeLimits(report) });
  return createShadowScene({ renderer, catcher, catches, occlusion, surface, watchLimits: () => {} });
}

function createVolumeLimits(report: DrawBinding['report']): VolumeLimits {
  const warn = (message: string): void =>
    report?.({ code: 'SCR024', severity: 'warning', port: 'casters', message, fix: 'Choose “Shadow map” as the method.' });
  return {
    tellShaped: (name) => warn(`The shadow of “${name}” ignores its alpha map or displacement map. Shadow volumes use whole triangles.`),
    tellSeeThrough: (name) =>
      warn(`The shadow of “${name}” ignores its transparency. It is solid, or absent where over half of the light passes.`),
  };
}
