import type { Texture } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { LoadedEnvironment } from '../../scene-backend.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { filledTexture, texturePixels } from './filled-texture.ts';
import { type LoadedPanorama, loadPanorama, panoramaOf } from './load-panorama.ts';
import { type Prefiltered, prefilter } from './prefilter.ts';
import type { ReadRadiance } from './read-radiance.ts';

/** Loaded panoramas with their prefiltered environments, shared by all scenes. */
export interface PanoramaStore {
  /** Rejects with an `Error` whose message is text for the user. */
  load(bytes: ArrayBuffer): Promise<LoadedEnvironment>;
  prefiltered(environment: EnvironmentAsset): Texture;
  dispose(): void;
}

/** `readRadiance` is null for pages without panoramas. */
export function createPanoramaStore(renderer: SceneRenderer, readRadiance: ReadRadiance | null): PanoramaStore {
  const filtered = new Map<EnvironmentAsset, Prefiltered>();
  /** Filters a panorama at once, instead of in a frame. */
  const complete = (panorama: LoadedPanorama): LoadedEnvironment => {
    const whole: LoadedEnvironment = {
      ...panorama,
      withoutLamps: (runs, size) => {
        const texture = filledTexture(panorama.texture, runs, size);
        return complete(panoramaOf(texture, () => texturePixels(texture)));
      },
      dispose: () => {
        filtered.get(whole)?.dispose();
        filtered.delete(whole);
        panorama.dispose();
      },
    };
    filtered.set(whole, prefilter(renderer, whole));
    return whole;
  };
  return {
    load: async (bytes) => {
      if (!readRadiance) throw new Error('The program has a panorama, but the page was made without.');
      return complete(await loadPanorama(bytes, renderer.three.capabilities.maxTextureSize, readRadiance));
    },
    prefiltered: (environment) => {
      const known = filtered.get(environment);
      if (!known) throw new Error('This panorama was not loaded here.');
      return known.texture;
    },
    dispose: () => {
      for (const { dispose } of filtered.values()) dispose();
      filtered.clear();
    },
  };
}
