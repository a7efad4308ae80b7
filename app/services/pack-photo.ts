import { createHash } from 'node:crypto';
import type { AssetCache } from '../../export/bundle/assets/model-cache.ts';
import { isJpeg } from '../../export/bundle/photos/image-form.ts';
import type { PhotoResults, PhotoTask } from '../../export/bundle/photos/photo-task.ts';
import type { PhotoWorkers } from '../../export/bundle/photos/photo-workers.ts';
import { isDistorted, type Lens } from '../../export/captures/lens.ts';
import { pinholeFor } from '../../export/captures/undistort.ts';
import { CaptureError, type Pinhole } from '../../nodes/kit/capture.ts';

/** A photograph as a capture contains it: without distortion and metadata. */
export interface PackedPhoto {
  readonly bytes: Uint8Array;
  readonly extension: '.jpg' | '.avif';
  readonly pinhole: Pinhole;
}

/** Part of the names of cache entries. Increase this number if the same photograph and lens give other bytes. */
const PACKING_VERSION = 3;
const HASH_BYTES = 32;

/**
 * Removes the distortion of a photograph and reduces it; the result is an AVIF file. A JPEG file that needs neither keeps its pixels; only its
 * metadata, such as where it was taken, are removed.
 *
 * @param cache Keeps what was drawn, so that an import that was interrupted continues where it was.
 * @throws CaptureError if it is neither a JPEG nor a PNG file, or is damaged.
 */
export async function packPhoto(
  file: Uint8Array,
  name: string,
  lens: Lens,
  maxSidePx: number,
  { cache, workers }: { readonly cache: AssetCache | null; readonly workers: PhotoWorkers },
): Promise<PackedPhoto> {
  const pinhole = pinholeFor(lens, maxSidePx);
  const isKept = !isDistorted(lens) && pinhole.widthPx === lens.widthPx;
  const plain = isKept ? withoutMetadata(file, name) : null;
  if (plain) return { bytes: plain, extension: '.jpg', pinhole };
  const entry = `packed-${PACKING_VERSION}-${hashOf(file, JSON.stringify([lens, pinhole])).toString('hex')}`;
  const kept = whole(await cache?.read(entry).catch(() => null));
  if (kept) return { bytes: kept, extension: '.avif', pinhole };
  const bytes = await workOn(name, workers, { kind: 'pack', file, lens: isKept ? null : lens, pinhole });
  // A cache that cannot be written only costs time.
  await cache?.write(entry, Buffer.concat([hashOf(bytes), bytes])).catch(() => {});
  return { bytes, extension: '.avif', pinhole };
}

/**
 * Lets a thread work on a photograph.
 *
 * @param name The name of the photograph, for messages.
 * @throws CaptureError
 */
export function workOn<K extends PhotoTask['kind']>(
  name: string,
  workers: PhotoWorkers,
  task: PhotoTask & { readonly kind: K },
): Promise<PhotoResults[K]> {
  return workers.run<K>(task).catch((error: unknown) => {
    throw new CaptureError(`the photograph ${name} ${error instanceof Error ? error.message : String(error)}`);
  });
}

function hashOf(...parts: readonly (Uint8Array | string)[]): Buffer {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part);
  return hash.digest();
}

/** The content of a cache entry, which begins with its hash; null if it is cut off. */
function whole(entry: Uint8Array | null | undefined): Uint8Array | null {
  if (!entry) return null;
  const bytes = Uint8Array.from(entry.subarray(HASH_BYTES));
  return hashOf(bytes).equals(entry.subarray(0, HASH_BYTES)) ? bytes : null;
}

const START_OF_SCAN = 0xda;
const END_OF_IMAGE = Buffer.of(0xff, 0xd9);
/** The application segment of Adobe, which says how colors are coded. */
const APP14 = 0xee;

/**
 * A JPEG file without its comments and application segments; null for other files, which are encoded anew.
 *
 * @throws CaptureError if the file was cut off: browsers show the rest of such a photograph in gray, or refuse it.
 */
function withoutMetadata(file: Uint8Array, name: string): Uint8Array | null {
  if (!isJpeg(file)) return null;
  const parts = [file.subarray(0, 2)];
  let at = 2;
  while (at + 4 <= file.length && file[at] === 0xff) {
    const marker = file[at + 1] ?? 0;
    if (marker === START_OF_SCAN) {
      if (Buffer.from(file.buffer, file.byteOffset + at, file.length - at).lastIndexOf(END_OF_IMAGE) < 0)
        throw new CaptureError(`the photograph ${name} is damaged (its end is missing)`);
      parts.push(file.subarray(at));
      return new Uint8Array(Buffer.concat(parts));
    }
    const end = at + 2 + (((file[at + 2] ?? 0) << 8) | (file[at + 3] ?? 0));
    const isMetadata = marker === 0xfe || (marker >= 0xe1 && marker <= 0xef && marker !== APP14);
    if (!isMetadata) parts.push(file.subarray(at, end));
    at = end;
  }
  return null;
}
