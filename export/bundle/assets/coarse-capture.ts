import { createHash } from 'node:crypto';
import { decode, encode } from 'jpeg-js';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import type { CaptureMesh } from '../../../nodes/kit/capture.ts';
import { COARSE_CAPTURE_TRIANGLES } from '../../../nodes/kit/capture-size.ts';
import type { AssetCache } from './model-cache.ts';

/** An error as large as the mesh: the number of triangles decides. */
const ANY_ERROR = 1;

/**
 * Reduces a mesh to about 3,000 triangles, for the time until the whole mesh is loaded.
 *
 * @returns Null for a mesh that is not much larger.
 */
export async function coarseMesh({ positions, indices }: CaptureMesh): Promise<CaptureMesh | null> {
  if (indices.length < 2 * 3 * COARSE_CAPTURE_TRIANGLES) return null;
  await MeshoptSimplifier.ready;
  // Meshes may have vertices of their own for each triangle.
  const remap = MeshoptSimplifier.generatePositionRemap(positions, 3);
  const welded = indices.map((vertex) => remap[vertex] ?? vertex);
  const target = 3 * COARSE_CAPTURE_TRIANGLES;
  let [kept] = MeshoptSimplifier.simplify(welded, positions, 3, target, ANY_ERROR);
  // Many small pieces cannot be reduced edge by edge.
  if (kept.length > 2 * target) [kept] = MeshoptSimplifier.simplifySloppy(welded, positions, 3, null, target, ANY_ERROR);
  if (kept.length === 0) return null;
  const [place, count] = MeshoptSimplifier.compactMesh(kept);
  const compact = new Float32Array(3 * count);
  for (let vertex = 0; vertex < place.length; vertex++) {
    const to = place[vertex] ?? 0;
    if (to < count) compact.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * to);
  }
  return { positions: compact, indices: Uint32Array.from(kept) };
}

/** Photographs above it get a reduced form. */
const SMALL_PHOTO_BYTES = 100_000;
const REDUCED_SIDE_PX = 640;
const REDUCED_QUALITY = 75;
/** Part of the names of cache entries. Increase this number if the reduction returns other bytes for the same photograph. */
const REDUCTION_VERSION = 1;

/**
 * Reduces a photograph of a capture to at most 640 pixels, which take some 50 KB.
 *
 * @param photo A JPEG file; other files have no reduced form.
 * @returns A JPEG file, or null for a photograph that has at most 100 KB or that the JPEG decoder cannot read.
 */
export async function reducedPhoto(photo: Uint8Array, cache: AssetCache | null): Promise<Uint8Array | null> {
  if (photo.length <= SMALL_PHOTO_BYTES || photo[0] !== 0xff || photo[1] !== 0xd8) return null;
  const name = `photo-${REDUCTION_VERSION}-${createHash('sha256').update(photo).digest('hex')}`;
  const kept = await cache?.read(name).catch(() => null);
  if (kept) return kept;
  const decoded = decodedPhoto(photo);
  if (decoded === null) return null;
  const { width, height, data } = decoded;
  const factor = Math.ceil(Math.max(width, height) / REDUCED_SIDE_PX);
  const reduced = new Uint8Array(encode(averaged(data, width, height, factor), REDUCED_QUALITY).data);
  await cache?.write(name, reduced).catch(() => {});
  return reduced;
}

/** Null if the decoder cannot read the file, such as one with arithmetic coding, which browsers may read. */
function decodedPhoto(photo: Uint8Array) {
  try {
    return decode(photo, { useTArray: true, maxMemoryUsageInMB: 2048, maxResolutionInMP: 68 });
  } catch {
    return null;
  }
}

/** Each pixel is the mean of about `factor` by `factor` pixels; every pixel counts once. */
function averaged(data: Uint8Array, widthPx: number, heightPx: number, factor: number) {
  const width = Math.max(1, Math.round(widthPx / factor));
  const height = Math.max(1, Math.round(heightPx / factor));
  const from = (at: number, count: number, sizePx: number): number => Math.round((at * sizePx) / count);
  const reduced = new Uint8Array(4 * width * height).fill(255);
  for (let y = 0; y < height; y++) {
    const [top, bottom] = [from(y, height, heightPx), from(y + 1, height, heightPx)];
    for (let x = 0; x < width; x++) {
      const [left, right] = [from(x, width, widthPx), from(x + 1, width, widthPx)];
      let [red, green, blue] = [0, 0, 0];
      for (let row = top; row < bottom; row++) {
        for (let at = 4 * (row * widthPx + left); at < 4 * (row * widthPx + right); at += 4) {
          red += data[at] ?? 0;
          green += data[at + 1] ?? 0;
          blue += data[at + 2] ?? 0;
        }
      }
      const count = (bottom - top) * (right - left);
      reduced.set([Math.round(red / count), Math.round(green / count), Math.round(blue / count)], 4 * (y * width + x));
    }
  }
  return { width, height, data: reduced };
}
