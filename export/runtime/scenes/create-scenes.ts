import { findLampsAtOnce } from '../../../nodes/kit/panorama/find-lamps.ts';
import type { NumberView } from '../../../nodes/kit/value-views.ts';
import type { CreateSceneBackend, SceneBackend, SceneHost, ShadowMaps } from '../scene-backend.ts';
import { createNearestDepth } from '../targets/nearest-depth.ts';
import { createNeutralEnvironment } from './environments/neutral.ts';
import { createPanoramaStore, type FindLamps } from './environments/panorama-store.ts';
import { type ReadRadiance, readRadiance } from './environments/read-radiance.ts';
import { type CreateGlass, createGlass } from './glass/glass-scene.ts';
import { createLightLimits, createTextureLimits, mapLimitsOf } from './lights/light-limits.ts';
import { createShadowMaps, type RenderedShadowMaps } from './lights/shadow-maps.ts';
import { createMaskScene } from './mask-scene.ts';
import { createEffectsPatch } from './materials/effects-patch.ts';
import { createOcclusionPatch } from './materials/occlusion-patch.ts';
import { createModelLoader, type ModelTools, NO_TOOLS } from './models/load-model.ts';
import { createSceneRenderer } from './scene-renderer.ts';
import { createShadedScene } from './shaded-scene.ts';
import { createShadowLayer } from './shadow-layer.ts';

export interface SceneTools extends ModelTools {
  readonly readRadiance?: ReadRadiance;
  readonly findLamps?: FindLamps;
  /** Creates what draws glass and what is behind it; pages without glass leave it out. */
  readonly createGlass?: CreateGlass;
}

const FULL_AMBIENT: NumberView = { value: 1 };

/**
 * The scene backend of the player by three.js: scenes of flat proxies, shadow maps and models, on the player's context and framebuffers.
 */
export const createScenes: CreateSceneBackend = (host) =>
  create(host, { ...NO_TOOLS, readRadiance, findLamps: findLampsAtOnce, createGlass });

/**
 * Creates a scene backend with the given tools only: decoders for compressed models, and optionally panoramas, the search for lamps, and
 * glass.
 */
export function createScenesWith(tools: SceneTools): CreateSceneBackend {
  return (host) => create(host, tools);
}

function create(host: SceneHost, tools: SceneTools): SceneBackend {
  const renderer = createSceneRenderer(host);
  const neutral = createNeutralEnvironment(renderer);
  const panoramas = createPanoramaStore(renderer, {
    readRadiance: tools.readRadiance ?? null,
    findLamps: tools.findLamps ?? null,
    delay: host.delay ?? null,
  });
  const glass = tools.createGlass?.(renderer, host.gl) ?? null;
  const limits = mapLimitsOf(renderer.three);
  return {
    serviceFor: (binding) => {
      const shadowMaps = binding.shadowMaps === null ? null : rendered(binding.shadowMaps);
      return {
        createScene: (look) => {
          const occlusion = binding.occlusion === null ? null : createOcclusionPatch(binding.occlusion);
          switch (look.kind) {
            case 'shaded':
              return createShadedScene({
                renderer,
                neutral,
                panoramas,
                ambient: look.ambient ?? FULL_AMBIENT,
                encoding: look.encoding ?? 'display',
                shadowMaps,
                occlusion,
                effects: binding.effects ? createEffectsPatch(binding.effects) : null,
                glass,
                watchLimits: createLightLimits(binding.report, 'all', limits),
                textureLimits: createTextureLimits(binding.report),
              });
            case 'shadow-catcher':
              return createShadowLayer({ renderer, look, maps: shadowMaps, occlusion, limits, report: binding.report });
            case 'mask':
              return createMaskScene({ renderer, shows: look.shows, occlusion });
          }
        },
      };
    },
    createShadowMaps: (casters, lights) => createShadowMaps(renderer, casters, lights),
    loadModel: createModelLoader(tools, renderer.three),
    loadEnvironment: panoramas.load,
    createEnvironment: panoramas.create,
    createNearestDepth,
    createUnder: glass?.createUnder ?? null,
    prepare: renderer.prepare,
    counts: () => {
      const { memory, programs } = renderer.three.info;
      return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
    },
    dispose: () => {
      neutral.dispose();
      panoramas.dispose();
      glass?.dispose();
      renderer.dispose();
    },
  };
}

/** Narrows the type of shadow maps: the player passes only those that `createShadowMaps` returned. */
function rendered(maps: ShadowMaps): RenderedShadowMaps {
  if (!('mapOf' in maps)) throw new Error('These shadow maps come from another backend.');
  return maps as RenderedShadowMaps;
}
