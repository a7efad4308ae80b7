import type { NumberView } from '../../../nodes/kit/runtime.ts';
import type { CreateSceneBackend, ShadowMaps } from '../scene-backend.ts';
import { createNeutralEnvironment } from './lights/environment.ts';
import { createShadowMaps, type RenderedShadowMaps } from './lights/shadow-maps.ts';
import { createOcclusionPatch } from './materials/occlusion-patch.ts';
import { loadModel } from './models/load-model.ts';
import { createSceneRenderer } from './scene-renderer.ts';
import { createShadedScene } from './shaded-scene.ts';
import { createShadowScene } from './shadow-scene.ts';

const FULL_AMBIENT: NumberView = { value: 1 };

/** three.js for the player: scenes of flat proxies, shadow maps and models, on the player's own context and framebuffers. */
export const createScenes: CreateSceneBackend = (host) => {
  const renderer = createSceneRenderer(host);
  const environment = createNeutralEnvironment(renderer);
  return {
    serviceFor: (binding) => {
      const shadowMaps = binding.shadowMaps === null ? null : rendered(binding.shadowMaps);
      return {
        createScene: (look) => {
          const occlusion = binding.occlusion === null ? null : createOcclusionPatch(binding.occlusion);
          switch (look.kind) {
            case 'shaded':
              return createShadedScene({ renderer, environment, ambient: look.ambient ?? FULL_AMBIENT, shadowMaps, occlusion });
            case 'shadow-catcher':
              return createShadowScene({ renderer, strength: look.strength, color: look.color, shadowMaps, occlusion });
          }
        },
      };
    },
    createShadowMaps: (casters, lights) => createShadowMaps(renderer, casters, lights),
    loadModel,
    invalidateState: renderer.invalidateState,
    counts: () => {
      const { memory, programs } = renderer.three.info;
      return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
    },
    dispose: () => {
      environment.dispose();
      renderer.dispose();
    },
  };
};

/** The player hands back what `createShadowMaps` gave it. */
function rendered(maps: ShadowMaps): RenderedShadowMaps {
  if (!('mapOf' in maps)) throw new Error('These shadow maps come from another backend.');
  return maps as RenderedShadowMaps;
}
