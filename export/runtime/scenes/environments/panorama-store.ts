import type { Texture } from 'three';
import type { EnvironmentAsset } from '../../../../nodes/kit/assets.ts';
import type { FoundLamps } from '../../../../nodes/kit/panorama/found-lamps.ts';
import type { LampOptions } from '../../../../nodes/kit/panorama/lamp-options.ts';
import type { PanoramaPixels } from '../../../../nodes/kit/panorama/pixels.ts';
import type { FrameClock } from '../../clock.ts';
import { type PartedWork, workAtOnce, workInTurns } from '../../gl/spread-work.ts';
import type { LoadedEnvironment } from '../../scene-backend.ts';
import type { SceneRenderer } from '../scene-renderer.ts';
import { bytesTexture, filledTexture, ownPixels } from './filled-texture.ts';
import { type LoadedPanorama, loadPanorama, panoramaOf, radianceTexture } from './load-panorama.ts';
import { type Prefiltered, prefilter } from './prefilter.ts';
import type { HalfPixels, ReadRadiance } from './read-radiance.ts';
import { uploadPanorama } from './upload-panorama.ts';

/** Loaded panoramas with their prefiltered environments, shared by all scenes. */
export interface PanoramaStore {
  /** Loads a panorama and filters it for lighting. Rejects with an `Error` whose message is text for the user. */
  load(bytes: ArrayBuffer, lamps?: EnvironmentAsset['lamps']): Promise<LoadedEnvironment>;
  /** Creates a panorama from pixels, see `AssetService.createEnvironment`. The caller disposes it. It may not be ready yet. */
  create(pixels: PanoramaPixels, lamps?: EnvironmentAsset['lamps']): LoadedEnvironment;
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

interface Completed {
  readonly whole: LoadedEnvironment;
  /** Null if it can be drawn already. */
  readonly settled: Promise<unknown> | null;
}

function isHalves(pixels: PanoramaPixels): pixels is HalfPixels {
  return pixels.data instanceof Uint16Array;
}

/** Panoramas of at most this width are uploaded at once, because that takes no longer than a turn. */
const AT_ONCE_PX = 1024;

/**
 * Creates the store.
 *
 * @param delay Null to upload and filter panoramas at once, as renders do. Otherwise both are spread over frames.
 */
export function createPanoramaStore(
  renderer: SceneRenderer,
  { readRadiance, findLamps, delay }: PanoramaTools & { readonly delay: FrameClock['delay'] | null },
): PanoramaStore {
  const filtered = new Map<EnvironmentAsset, Prefiltered>();
  const disposed = new WeakSet<EnvironmentAsset>();
  let isOver = false;

  /** Uploads a panorama and filters it, before any frame uses it. */
  function* light(whole: LoadedEnvironment, before: PartedWork | null): PartedWork {
    if (before) yield* before;
    if (delay && whole.widthPx > AT_ONCE_PX) yield* uploadPanorama(renderer, whole.texture);
    filtered.set(whole, yield* prefilter(renderer, whole));
  }

  /** Completes a panorama with what lighting needs. `settled` resolves when it can be drawn. `before`: work that makes its pixels. */
  const complete = (panorama: LoadedPanorama, lamps?: EnvironmentAsset['lamps'], before: PartedWork | null = null): Completed => {
    const whole: LoadedEnvironment = {
      ...panorama,
      ...(lamps ? { lamps } : {}),
      ...(findLamps ? { findLamps: (options) => findLamps(atOnce(panorama.readPixels()), options) } : {}),
      get ready() {
        return filtered.has(whole);
      },
      withoutLamps: (runs, size) => {
        const { texture, fill } = filledTexture(panorama.texture, runs, size);
        return complete(
          panoramaOf(texture, () => ownPixels(texture)),
          undefined,
          fill,
        ).whole;
      },
      dispose: () => {
        disposed.add(whole);
        filtered.get(whole)?.dispose();
        filtered.delete(whole);
        panorama.dispose();
      },
    };
    const work = light(whole, before);
    if (delay === null) {
      workAtOnce(work);
      return { whole, settled: null };
    }
    const gl = renderer.three.getContext() as WebGL2RenderingContext;
    return { whole, settled: workInTurns(work, { gl, delay, isOver: () => isOver || disposed.has(whole) }) };
  };
  return {
    load: async (bytes, lamps) => {
      if (!readRadiance) throw new Error('The program has a panorama, but the page was made without.');
      const { whole, settled } = complete(await loadPanorama(bytes, renderer.three.capabilities.maxTextureSize, readRadiance), lamps);
      await settled;
      return whole;
    },
    create: (pixels, lamps) => {
      const texture = isHalves(pixels) ? radianceTexture(pixels) : bytesTexture(pixels);
      return complete(
        panoramaOf(texture, () => ({ ...pixels, data: pixels.data.slice() })),
        lamps,
      ).whole;
    },
    prefiltered: (environment) => {
      const known = filtered.get(environment);
      if (!known) throw new Error('This panorama was not loaded here.');
      return known.texture;
    },
    dispose: () => {
      isOver = true;
      for (const { dispose } of filtered.values()) dispose();
      filtered.clear();
    },
  };
}
