import { ASSET_WORDS } from '../../../nodes/kit/asset-words.ts';
import type { AssetHandle, AssetService, EnvironmentAsset, ImageAsset, ModelAsset, VideoAsset } from '../../../nodes/kit/assets.ts';
import type { CaptureAsset } from '../../../nodes/kit/capture-asset.ts';
import type { AssetKind } from '../../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { AudioAsset } from '../../../nodes/kit/sound.ts';
import type { SplatAsset } from '../../../nodes/kit/splat-asset.ts';
import type { ProgramAsset } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { OwnedObjects } from '../gl/owned-objects.ts';
import type { LoadedEnvironment, LoadedModel, SceneBackend } from '../scene-backend.ts';
import { missing, wrongKind } from './asset-mistakes.ts';
import type { AssetSource } from './asset-source.ts';
import { type LoadedCapture, loadCapture } from './capture/load-capture.ts';
import { type LoadedAudio, loadAudio } from './load-audio.ts';
import { type LoadedImage, loadImage } from './load-image.ts';
import { type LoadedSplats, loadSplats } from './splats/load-splats.ts';
import { type LoadedVideo, loadVideo } from './video/load-video.ts';

/** The assets of a player. Each file is loaded once, shared by its users, and disposed with its last user. */
export interface AssetStore {
  /** Loads the assets of a program and keeps them loaded until the hold is released, so that nodes share them. */
  hold(assets: readonly ProgramAsset[]): AssetHold;
  /** The service for one node, which finds assets by their id in `assets`. */
  serviceFor(assets: readonly ProgramAsset[], report: (diagnostic: Omit<Diagnostic, 'nodeId'>) => void): AssetService;
  dispose(): void;
}

export interface AssetHold {
  /** Resolves when each asset can be drawn, perhaps not in its final form, or failed; never rejects. */
  readonly usable: Promise<void>;
  /** Resolves when each asset has loaded or failed; never rejects. */
  readonly settled: Promise<void>;
  release(): void;
}

type Loaded = LoadedAudio | LoadedCapture | LoadedImage | LoadedModel | LoadedSplats | LoadedVideo | LoadedEnvironment;

interface Entry {
  readonly asset: ProgramAsset;
  users: number;
  value: Loaded | null;
  failure: Omit<Diagnostic, 'nodeId'> | null;
  readonly usable: Promise<void>;
  readonly settled: Promise<void>;
  /** Called when the value has been disposed. */
  end?(): void;
}

/** What the store needs to load and decode files. */
export interface AssetMeans {
  readonly objects: GlObjects;
  readonly source: AssetSource;
  readonly scenes: () => SceneBackend;
  readonly delay: FrameClock['delay'];
  /** Follows the GPU objects of assets, in the preview. */
  readonly owned: OwnedObjects | null;
}

export function createAssetStore(means: AssetMeans): AssetStore {
  const entries = new Map<string, Entry>();

  const acquire = (asset: ProgramAsset): Entry => {
    const key = keyOf(asset);
    let entry = entries.get(key);
    if (!entry) {
      entry = start(asset);
      entries.set(key, entry);
    }
    entry.users++;
    return entry;
  };
  const release = (entry: Entry): void => {
    if (--entry.users > 0) return;
    entries.delete(keyOf(entry.asset));
    drop(entry);
  };
  const start = (asset: ProgramAsset): Entry => {
    let isUsable = (): void => {};
    const usable = new Promise<void>((resolve) => {
      isUsable = resolve;
    });
    const show = (value: Loaded): void => {
      // All users may have released it while it was loading.
      if (entry.users > 0) entry.value = value;
      else {
        value.dispose();
        entry.end?.();
      }
      isUsable();
    };
    const finish = (result: LoadResult): void => {
      if (result.kind === 'failed') entry.failure = result.failure;
      else show(result.value);
      isUsable();
    };
    const followed = means.owned?.followAsset(asset.path, means.objects);
    const entry: Entry = {
      asset,
      users: 0,
      value: null,
      failure: null,
      usable,
      settled: load(asset, followed ? { ...means, objects: followed.objects } : means, show).then(finish),
    };
    if (followed) entry.end = followed.end;
    return entry;
  };
  const handle = <T>(kind: AssetKind, asset: ProgramAsset, report: (d: Omit<Diagnostic, 'nodeId'>) => void): AssetHandle<T> => {
    const entry = acquire(asset);
    let released = false;
    return {
      kind,
      get value() {
        return released ? null : (entry.value as T | null);
      },
      settled: entry.settled.then(() => {
        if (released) return;
        if (entry.failure) report(entry.failure);
        if (entry.value && 'findings' in entry.value) for (const finding of entry.value.findings) report(finding);
      }),
      release: () => {
        if (!released) release(entry);
        released = true;
      },
    };
  };
  return {
    hold: (assets) => {
      const held = assets.map(acquire);
      return {
        usable: Promise.all(held.map((entry) => entry.usable)).then(() => {}),
        settled: Promise.all(held.map((entry) => entry.settled)).then(() => {}),
        release: () => {
          for (const entry of held.splice(0)) release(entry);
        },
      };
    },
    serviceFor: (assets, report) => {
      const find = <T>(kind: AssetKind, id: string): AssetHandle<T> => {
        const asset = assets.find((a) => a.id === id);
        if (asset?.kind === kind) return handle<T>(kind, asset, report);
        report(asset ? wrongKind(asset, kind) : missing(id));
        return { kind, value: null, settled: Promise.resolve(), release: () => {} };
      };
      return {
        image: (id) => find<ImageAsset>('image', id),
        model: (id) => find<ModelAsset>('model', id),
        video: (id) => find<VideoAsset>('video', id),
        audio: (id) => find<AudioAsset>('audio', id),
        capture: (id) => find<CaptureAsset>('capture', id),
        splats: (id) => find<SplatAsset>('splats', id),
        environment: (id) => find<EnvironmentAsset>('environment', id),
        createEnvironment: (pixels, lamps) => means.scenes().createEnvironment(pixels, lamps),
      };
    },
    dispose: () => {
      for (const entry of entries.values()) {
        entry.users = 0;
        drop(entry);
      }
      entries.clear();
    },
  };
}

/** Disposes what is loaded. What still loads is disposed when it arrives. */
function drop(entry: Entry): void {
  if (!entry.value) return;
  entry.value.dispose();
  entry.value = null;
  entry.end?.();
}

/** Users that need other parts of a file do not share it. */
function keyOf({ kind, path, depthMeshes }: ProgramAsset): string {
  return `${kind} ${path}${depthMeshes ? ' with depth meshes' : ''}`;
}

type LoadResult =
  | { readonly kind: 'loaded'; readonly value: Loaded }
  | { readonly kind: 'failed'; readonly failure: Omit<Diagnostic, 'nodeId'> };

/** Loads an asset. `show` receives it earlier if it can be drawn before it is complete. */
async function load(asset: ProgramAsset, means: AssetMeans, show: (value: Loaded) => void): Promise<LoadResult> {
  let bytes: ArrayBuffer;
  try {
    bytes = await means.source.load(asset.path);
  } catch (error) {
    return { kind: 'failed', failure: unreadable(asset, error) };
  }
  try {
    return { kind: 'loaded', value: await decode(asset, bytes, means, show) };
  } catch (error) {
    return { kind: 'failed', failure: undecodable(asset, error) };
  }
}

function decode(
  { kind, path, lamps, depthMeshes, phoneGpuBytes }: ProgramAsset,
  bytes: ArrayBuffer,
  { objects, source, scenes, delay }: AssetMeans,
  show: (value: Loaded) => void,
): Promise<Loaded> {
  switch (kind) {
    case 'image':
      return loadImage(objects, bytes);
    case 'video':
      return loadVideo(objects, bytes, delay);
    case 'audio':
      return loadAudio(bytes);
    case 'capture':
      return loadCapture(objects, bytes, path, source.load, depthMeshes === true, show, delay);
    case 'splats':
      return loadSplats(objects, bytes, path, phoneGpuBytes);
    case 'model':
      return scenes().loadModel(bytes, path, source.load);
    case 'environment':
      return scenes().loadEnvironment(bytes, lamps);
  }
}

function unreadable(asset: ProgramAsset, error: unknown): Omit<Diagnostic, 'nodeId'> {
  const message = `The ${ASSET_WORDS[asset.kind]} "${asset.path}" cannot be read: ${reason(error)}.`;
  return {
    code: 'SCR030',
    severity: 'error',
    message,
    fix: 'Check that the file is in the project folder, or choose another one.',
  };
}

function undecodable(asset: ProgramAsset, error: unknown): Omit<Diagnostic, 'nodeId'> {
  const message = `The ${ASSET_WORDS[asset.kind]} "${asset.path}" cannot be decoded: ${reason(error)}.`;
  return {
    code: 'SCR032',
    severity: 'error',
    message,
    fix: knownFix(error) ?? 'Check that the file opens in another program, or save it again.',
  };
}

function knownFix(error: unknown): string | null {
  return error instanceof Error && 'fix' in error && typeof error.fix === 'string' ? error.fix : null;
}

function reason(error: unknown): string {
  const text = error instanceof Error ? error.message : String(error);
  return text.replace(/\.$/, '');
}
