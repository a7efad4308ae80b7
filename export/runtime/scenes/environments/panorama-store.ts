import type { Texture } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { FoundLamps } from '../../../../nodes/kit/panorama/found-lamps.ts';
import type { LampOptions } from '../../../../nodes/kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import type { LoadedEnvironment } from '../../scene-backend.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { bytesTexture, filledTexture, ownPixels } from './filled-texture.ts';
import { type LoadedPanorama, loadPanorama, panoramaOf } from './load-panorama.ts';
import { type Prefiltered, prefilter } from './prefilter.ts';
import type { ReadRadiance } from './read-radiance.ts';

/** Loaded panoramas with their prefiltered environments, shared by all scenes. */
export interface PanoramaStore {
  /** Loads a panorama and filters it for lighting. Rejects with an `Error` whose message is text for the user. */
  load(bytes: ArrayBuffer, lamps?: EnvironmentAsset['lamps']): Promise<LoadedEnvironment>;
  /** Creates a panorama from bytes with four channels, rows from the top, and filters it for lighting. The caller disposes it. */
  create(pixels: PanoramaPixels): LoadedEnvironment;
  prefiltered(environment: EnvironmentAsset): Texture;
  dispose(): void;
}

/** Finds the lamps of a panorama synchronously. Only renders do so; the function is injected, so that pages do not bundle it. */
export type FindLamps = (pixels: PanoramaPixels, options: LampOptions) => FoundLamps;

export interface PanoramaTools {
  /** Decodes Radiance HDR and OpenEXR; null for pages without panoramas. */
  readonly readRadiance: ReadRadiance | null;
  readonly findLamps: FindLamps | null;
}

/** Renders, which search at once, decode at once too. */
function atOnce(pixels: PanoramaPixels | Promise<PanoramaPixels>): PanoramaPixels {
  if (pixels instanceof Promise) throw new Error('A panorama that a worker decodes cannot be searched at once.');
  return pixels;
}

export function createPanoramaStore(renderer: SceneRenderer, { readRadiance, findLamps }: PanoramaTools): PanoramaStore {
  const filtered = new Map<EnvironmentAsset, Prefiltered>();
  /** Completes a panorama with what lighting needs. It is filtered immediately, not in the first frame that uses it. */
  const complete = (panorama: LoadedPanorama, lamps?: EnvironmentAsset['lamps']): LoadedEnvironment => {
    const whole: LoadedEnvironment = {
      ...panorama,
      ...(lamps ? { lamps } : {}),
      ...(findLamps ? { findLamps: (options) => findLamps(atOnce(panorama.readPixels()), options) } : {}),
      withoutLamps: (runs, size) => {
        const texture = filledTexture(panorama.texture, runs, size);
        return complete(panoramaOf(texture, () => ownPixels(texture)));
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
    load: async (bytes, lamps) => {
      if (!readRadiance) throw new Error('The program has a panorama, but the page was made without.');
      return complete(await loadPanorama(bytes, renderer.three.capabilities.maxTextureSize, readRadiance), lamps);
    },
    create: (pixels) => {
      const texture = bytesTexture(pixels);
      return complete(panoramaOf(texture, () => ({ ...pixels, data: pixels.data.slice() })));
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
