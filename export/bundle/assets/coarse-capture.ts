import { createHash } from 'node:crypto';
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import type { CaptureMesh } from '../../../nodes/kit/capture.ts';
import { COARSE_CAPTURE_TRIANGLES } from '../../../nodes/kit/capture-size.ts';
import { isAvif, isJpeg } from '../photos/image-form.ts';
import type { PhotoWorkers } from '../photos/photo-workers.ts';
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
/** Part of the names of cache entries. Increase this number if the reduction returns other bytes for the same photograph. */
const REDUCTION_VERSION = 2;

/**
 * Reduces a photograph of a capture to at most 640 pixels, which take some 25 KB.
 *
 * @param photo A JPEG or AVIF file; other files have no reduced form.
 * @returns An AVIF file, or null for a photograph that has at most 100 KB or that the decoders cannot read, such as a JPEG file with
 * arithmetic coding, which browsers may read.
 */
export async function reducedPhoto(photo: Uint8Array, cache: AssetCache | null, workers: PhotoWorkers): Promise<Uint8Array | null> {
  if (photo.length <= SMALL_PHOTO_BYTES || !(isJpeg(photo) || isAvif(photo))) return null;
  const name = `photo-${REDUCTION_VERSION}-${createHash('sha256').update(photo).digest('hex')}`;
  const kept = await cache?.read(name).catch(() => null);
  if (kept) return kept;
  const reduced = await workers.run({ kind: 'reduce', file: photo }).catch(() => null);
  if (reduced) await cache?.write(name, reduced).catch(() => {});
  return reduced;
}
