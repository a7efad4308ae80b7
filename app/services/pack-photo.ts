import { createHash } from 'node:crypto';
import { decode as decodePng } from 'fast-png';
import { decode as decodeJpeg, encode as encodeJpeg } from 'jpeg-js';
import type { AssetCache } from '../../export/bundle/assets/model-cache.ts';
import { isDistorted, type Lens } from '../../export/captures/lens.ts';
import { type Photo, pinholeFor, resample } from '../../export/captures/undistort.ts';
import { CaptureError, type Pinhole } from '../../nodes/kit/capture.ts';

/** A photograph as a capture contains it: without distortion and metadata. */
export interface PackedPhoto {
  readonly bytes: Uint8Array;
  readonly extension: '.jpg' | '.png';
  readonly pinhole: Pinhole;
}

const JPEG_QUALITY = 92;
/** Part of the names of cache entries. Increase this number if the same photograph and lens give other bytes. */
const PACKING_VERSION = 1;
const HASH_BYTES = 32;

/**
 * Removes the distortion of a photograph and reduces it. A photograph that needs neither keeps its pixels; only its metadata, such as where
 * it was taken, are removed.
 *
 * @param cache Keeps what was drawn, so that an import that was interrupted continues where it was.
 * @throws CaptureError if it is neither a JPEG nor a PNG file, or is damaged.
 */
export async function packPhoto(
  file: Uint8Array,
  name: string,
  lens: Lens,
  maxSidePx: number,
  cache: AssetCache | null,
): Promise<PackedPhoto> {
  const pinhole = pinholeFor(lens, maxSidePx);
  const isKept = !isDistorted(lens) && pinhole.widthPx === lens.widthPx;
  const plain = isKept
    ? (withoutMetadata(file, name) ?? (isPng(file) ? { bytes: pngAsJpeg(file, name), extension: '.jpg' as const } : null))
    : null;
  if (plain) return { ...plain, pinhole };
  const entry = `packed-${PACKING_VERSION}-${hashOf(file, JSON.stringify([lens, pinhole])).toString('hex')}`;
  const kept = whole(await cache?.read(entry).catch(() => null));
  if (kept) return { bytes: kept, extension: '.jpg', pinhole };
  const bytes = encode(resample(decodePhoto(file, name), lens, pinhole));
  // A cache that cannot be written only costs time.
  await cache?.write(entry, Buffer.concat([hashOf(bytes), bytes])).catch(() => {});
  return { bytes, extension: '.jpg', pinhole };
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

function encode({ widthPx, heightPx, data }: Photo): Uint8Array {
  return new Uint8Array(encodeJpeg({ width: widthPx, height: heightPx, data }, JPEG_QUALITY).data);
}

function pngAsJpeg(file: Uint8Array, name: string): Uint8Array {
  return encode(decodePhoto(file, name));
}

function isPng(file: Uint8Array): boolean {
  return file[0] === 0x89 && file[1] === 0x50;
}

function isJpeg(file: Uint8Array): boolean {
  return file[0] === 0xff && file[1] === 0xd8;
}

/**
 * Reads the pixels of a JPEG or PNG file.
 *
 * @param name The name of the photograph, for messages.
 * @throws CaptureError
 */
export function decodePhoto(file: Uint8Array, name: string): Photo {
  try {
    if (isJpeg(file)) {
      const { width, height, data } = decodeJpeg(file, { useTArray: true, maxMemoryUsageInMB: 2048, maxResolutionInMP: 68 });
      return { widthPx: width, heightPx: height, data };
    }
    if (isPng(file)) return fromPng(file);
  } catch (error) {
    throw new CaptureError(`the photograph ${name} is damaged (${error instanceof Error ? error.message : String(error)})`);
  }
  throw new CaptureError(`the photograph ${name} is neither a JPEG nor a PNG file`);
}

function fromPng(file: Uint8Array): Photo {
  const { width, height, data, channels, depth, palette } = decodePng(file);
  const rgba = new Uint8Array(width * height * 4).fill(255);
  const shift = depth === 16 ? 8 : 0;
  for (let i = 0; i < width * height; i++) {
    const listed = palette?.[data[i] ?? 0];
    for (let c = 0; c < 3; c++) {
      const value = listed ? listed[c] : (data[i * channels + (channels < 3 ? 0 : c)] ?? 0) >> shift;
      rgba[4 * i + c] = value ?? 0;
    }
  }
  return { widthPx: width, heightPx: height, data: rgba };
}

const START_OF_SCAN = 0xda;
const END_OF_IMAGE = Buffer.of(0xff, 0xd9);
/** The application segment of Adobe, which says how colors are coded. */
const APP14 = 0xee;

/**
 * A JPEG file without its comments and application segments; null for other files, whose pixels are encoded anew.
 *
 * @throws CaptureError if the file was cut off: browsers show the rest of such a photograph in gray, or refuse it.
 */
function withoutMetadata(file: Uint8Array, name: string): { readonly bytes: Uint8Array; readonly extension: '.jpg' } | null {
  if (!isJpeg(file)) return null;
  const parts = [file.subarray(0, 2)];
  let at = 2;
  while (at + 4 <= file.length && file[at] === 0xff) {
    const marker = file[at + 1] ?? 0;
    if (marker === START_OF_SCAN) {
      if (Buffer.from(file.buffer, file.byteOffset + at, file.length - at).lastIndexOf(END_OF_IMAGE) < 0)
        throw new CaptureError(`the photograph ${name} is damaged (its end is missing)`);
      parts.push(file.subarray(at));
      return { bytes: new Uint8Array(Buffer.concat(parts)), extension: '.jpg' };
    }
    const end = at + 2 + (((file[at + 2] ?? 0) << 8) | (file[at + 3] ?? 0));
    const isMetadata = marker === 0xfe || (marker >= 0xe1 && marker <= 0xef && marker !== APP14);
    if (!isMetadata) parts.push(file.subarray(at, end));
    at = end;
  }
  return null;
}
