import { createPhotoWorkers } from '../../export/bundle/photos/photo-workers.ts';
import { packedSidePx } from '../../export/captures/packed-side.ts';
import type { Photo } from '../../export/captures/undistort.ts';
import { createAssetCache } from './asset-cache-folder.ts';
import type { FileLayer } from './file-layer.ts';
import { type PackedPhoto, packPhoto, workOn } from './pack-photo.ts';
import type { FoundView } from './read-capture-folder.ts';
import { readSource } from './read-source.ts';

export interface PackingJob {
  /** Real path of the project. */
  readonly root: string;
  /** Absolute path of the folder with Scrim's sources and `node_modules`. */
  readonly sources: string;
  /** Photographs are reduced to this longest side, pixels. */
  readonly maxSidePx: number;
  readonly files: FileLayer;
  readonly interrupted: AbortSignal;
}

/** Photographs of an import, which threads pack ahead. */
export interface PackedPhotos {
  /** The photograph of a view. Ask for them in order, each once. */
  next(): Promise<PackedPhoto>;
  /** The pixels of a photograph that was packed. */
  decode(bytes: Uint8Array, name: string): Promise<Photo>;
}

const MAX_PHOTO_BYTES = 256 * 2 ** 20;

/**
 * Runs a task with the photographs of an import. Threads pack those that are next, one each, so memory does not grow with the number of views.
 * An interrupt ends them; what they have packed stays in the cache of the project.
 */
export async function withPackedPhotos<T>(
  { root, sources, files, maxSidePx, interrupted }: PackingJob,
  views: readonly FoundView[],
  task: (photos: PackedPhotos) => Promise<T>,
): Promise<T> {
  const largest = views.reduce((most, { lens }) => Math.max(most, lens.widthPx * lens.heightPx), 1);
  const workers = createPhotoWorkers(sources, largest);
  const cache = createAssetCache(root, files);
  const pack = async ({ file, lens, view }: FoundView): Promise<PackedPhoto> => {
    const side = packedSidePx(maxSidePx, lens.projection === 'equirectangular');
    return packPhoto(await readSource(file, MAX_PHOTO_BYTES), view.name, lens, side, { cache, workers });
  };
  const started: Promise<PackedPhoto>[] = [];
  const left = [...views];
  const next = (): Promise<PackedPhoto> => {
    while (started.length <= workers.count) {
      const view = left.shift();
      if (!view) break;
      const packing = pack(view);
      // Those that come before are asked for first.
      packing.catch(() => {});
      started.push(packing);
    }
    return started.shift() ?? Promise.reject(new Error('There are no more photographs.'));
  };
  const unlessInterrupted = (error: unknown): never => {
    interrupted.throwIfAborted();
    throw error;
  };
  interrupted.addEventListener('abort', workers.dispose);
  try {
    return await task({
      next: () => next().catch(unlessInterrupted),
      decode: (file, name) => workOn(name, workers, { kind: 'decode', file }).catch(unlessInterrupted),
    });
  } finally {
    interrupted.removeEventListener('abort', workers.dispose);
    await workers.dispose();
  }
}
