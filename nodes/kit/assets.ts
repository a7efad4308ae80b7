import type { AnimationClip, Object3D, Texture } from 'three';
import type { CaptureAsset } from './capture-asset.ts';
import type { AssetKind } from './definition.ts';
import type { FoundLamps } from './panorama/found-lamps.ts';
import type { LampOptions } from './panorama/lamp-options.ts';
import type { PanoramaPixels } from './panorama/pixels.ts';
import type { AudioAsset } from './sound.ts';
import type { SplatAsset } from './splat-asset.ts';

/**
 * Loads the project's assets. Each asset is loaded once and shared by all its handles; it is disposed when the last handle is released.
 *
 * @example
 * const image = ctx.assetIds.file === null ? null : ctx.assets.image(ctx.assetIds.file);
 * // In `update`: image?.value is null until the file has loaded.
 * // In `dispose`: image?.release();
 */
export interface AssetService {
  image(id: string): AssetHandle<ImageAsset>;
  model(id: string): AssetHandle<ModelAsset>;
  environment(id: string): AssetHandle<EnvironmentAsset>;
  video(id: string): AssetHandle<VideoAsset>;
  audio(id: string): AssetHandle<AudioAsset>;
  capture(id: string): AssetHandle<CaptureAsset>;
  splats(id: string): AssetHandle<SplatAsset>;
  /**
   * Creates a panorama that is not a file, filtered for lighting.
   *
   * @param pixels Bytes or half floats with four channels. They are not copied.
   * @param lamps Lamps that were found in it when the page was exported.
   * @returns The caller disposes it.
   */
  createEnvironment(pixels: PanoramaPixels, lamps?: EnvironmentAsset['lamps']): DerivedEnvironment;
}

/** One node's reference to a shared asset. The node must release each of its handles in its `dispose`. */
export interface AssetHandle<T> {
  readonly kind: AssetKind;
  /** The loaded asset. Null until it has loaded, and if loading fails. A failure is reported once, at the node. */
  readonly value: T | null;
  /** Resolves when loading has succeeded or failed; never rejects. */
  readonly settled: Promise<void>;
  release(): void;
}

/** A decoded image: premultiplied display-referred sRGB, RGBA8, rows from the bottom. */
export interface ImageAsset {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
}

/** A decoded glTF model, in meters, y up. */
export interface ModelAsset {
  /**
   * Creates an instance of the model, with its own bones; geometries, materials and textures are shared. `normals`: the shading of meshes
   * that have no normals in the file; absent: flat, as glTF demands.
   */
  instantiate(normals?: 'flat' | 'smooth'): Object3D;
  readonly clips: readonly AnimationClip[];
}

/** An equirectangular panorama. Samples are linear-sRGB radiance; the center is at `u` 0.5, the zenith at `v` 1. */
export interface EnvironmentAsset {
  readonly texture: Texture;
  readonly widthPx: number;
  readonly heightPx: number;
  /**
   * Reads the pixels at the precision of the file. It decodes the file again, so call it once. The caller owns the pixels, and may transfer
   * them to a worker. A worker may decode it, which gives a promise.
   */
  readPixels(): PanoramaPixels | Promise<PanoramaPixels>;
  /** The lamps that were found when the page was exported; the keys come from `lampKey`. */
  readonly lamps?: Readonly<Record<string, FoundLamps>>;
  /** Finds lamps synchronously, for renders. Exported pages leave the function out: they use stored lamps or a worker. */
  findLamps?(options: LampOptions): FoundLamps;
  /**
   * Creates a copy in which the pixels of lamps are filled from their surroundings, filtered for lighting.
   *
   * @param runs Pixels of an image of `size`, as `[y, first x, last x + 1, …]`, rows from the top.
   * @param size Size of the image that `runs` refers to.
   * @returns The caller disposes it.
   */
  withoutLamps(runs: readonly number[], size: { readonly widthPx: number; readonly heightPx: number }): DerivedEnvironment;
}

/** A panorama that a node has created or derived from another. */
export interface DerivedEnvironment extends EnvironmentAsset {
  /**
   * Whether it can be drawn. A large panorama is uploaded and filtered over several frames; nodes output it from then on. While the clock is
   * held it is ready at once.
   */
  readonly ready: boolean;
  dispose(): void;
}

/** A video file that can be played. */
export interface VideoAsset {
  readonly durationS: number;
  readonly widthPx: number;
  readonly heightPx: number;
  /**
   * Creates a playback with its own position.
   *
   * @param onProblem Called when the video cannot play: what is wrong, and the remedy, as sentences for users.
   */
  open(onProblem: (problem: { readonly message: string; readonly fix: string }) => void): VideoPlayback;
}

/** One playback of a video. */
export interface VideoPlayback {
  /** The newest decoded frame; null before the first. */
  readonly image: ImageAsset | null;
  /** Increases with every decoded frame. */
  readonly version: number;
  /**
   * Requests the frame at a position. Call it every frame.
   *
   * @param timeS Position in the file, seconds, in [0, durationS].
   * @param rate Above 0: the video plays on at this speed and is corrected when it deviates from `timeS`. 0: exactly this frame.
   * @param loop Whether playback continues from the end to the start.
   */
  follow(timeS: number, rate: number, loop: boolean): void;
  /** Resolves when the requested frame is available (see `NodeRuntime.settle`); null if it is available already. */
  settle(): Promise<void> | null;
  dispose(): void;
}
