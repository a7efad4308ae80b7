import type { AnimationClip, Object3D, Texture } from 'three';
import type { AssetKind } from './definition.ts';
import type { AudioAsset } from './sound.ts';

/** Loads each asset once and shares it; handles are counted, and the last release frees it. */
export interface AssetService {
  image(id: string): AssetHandle<ImageAsset>;
  model(id: string): AssetHandle<ModelAsset>;
  environment(id: string): AssetHandle<EnvironmentAsset>;
  video(id: string): AssetHandle<VideoAsset>;
  audio(id: string): AssetHandle<AudioAsset>;
}

export interface AssetHandle<T> {
  readonly kind: AssetKind;
  /** Null until loaded, and for ever when it failed: the failure is reported once, at the node. */
  readonly value: T | null;
  /** Resolves when loading ended, well or badly; never rejects. */
  readonly settled: Promise<void>;
  release(): void;
}

export interface ImageAsset {
  readonly texture: WebGLTexture;
  readonly widthPx: number;
  readonly heightPx: number;
}

export interface ModelAsset {
  /** Each call makes a new subtree with bones of its own, sharing geometries, materials and textures. */
  instantiate(): Object3D;
  readonly clips: readonly AnimationClip[];
}

/** Equirectangular radiance, linear where it is sampled; its middle is `u` 0.5, and `v` 1 is the zenith. */
export interface EnvironmentAsset {
  readonly texture: Texture;
  readonly widthPx: number;
  readonly heightPx: number;
}

export interface VideoAsset {
  readonly durationS: number;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Each call makes a playback with a time of its own. `onProblem` is told what hinders it, in words, and what to do. */
  open(onProblem: (problem: { readonly message: string; readonly fix: string }) => void): VideoPlayback;
}

export interface VideoPlayback {
  /** The newest picture that is there; null before the first. */
  readonly picture: ImageAsset | null;
  /**
   * Asks for the picture at `timeS` of the file, in [0, durationS]; every frame. A `rate` above 0 lets the video run on by itself
   * at this speed, `loop` from its end to its start, and puts it right where it strays; 0 asks for exactly this picture.
   */
  follow(timeS: number, rate: number, loop: boolean): void;
  /** As `NodeRuntime.settle`. */
  settle(): Promise<void> | null;
  dispose(): void;
}
