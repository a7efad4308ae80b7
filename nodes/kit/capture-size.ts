import type { CaptureDocument, CaptureMeshFile } from './capture.ts';

/** Memory for photographs on the GPU, with mip levels. Larger photographs are all reduced to fit. */
const MAX_PHOTO_GPU_BYTES = 128 * 2 ** 20;
const PHOTO_BYTES_PER_PIXEL = 4 * (4 / 3);
const MAX_DEPTH_SIDE_PX = 512;
const DEPTH_BYTES_PER_PIXEL = 4;
/** Position and color of a vertex; three indices. */
const VERTEX_BYTES = 16;
const TRIANGLE_BYTES = 12;
const DEPTH_VERTEX_BYTES = 8;
const HIDDEN_VERTEX_BYTES = 12;
/** A normal, and the weights of two eyes (`updateFrames`). */
const WEIGHT_BYTES = 4 + 2 * 16;
/** The camera of a view. */
const VIEW_BYTES = 64;

/** The most that a capture takes of the GPU of a phone or headset in a page. */
export const PHONE_CAPTURE_GPU_BYTES = 128e6;
/** The largest texture of most phones. */
export const PHONE_TEXTURE_PX = 4096;
/** The mesh takes at most this part of it, else the coarse one stays; with depth meshes this part, else they are left out. */
const MOST_MESH = 0.5;
const MOST_MESHES = 0.6;
/** By this factor, photographs are made smaller until they fit. */
const REDUCTION = 0.98;

/** Triangles of the coarse mesh that pages of several files have: 54 KB, which arrive in 0.3 s over 1.6 Mbit/s. */
export const COARSE_CAPTURE_TRIANGLES = 3000;

/** The size of the texture arrays of a capture in pixels, and the bytes that it takes on the GPU. */
export interface CaptureSize {
  readonly photoPx: readonly [width: number, height: number];
  readonly depthPx: readonly [width: number, height: number];
  /** False if only the coarse mesh has room. */
  readonly wholeMesh: boolean;
  /** Whether there are depth meshes that are drawn and have room. */
  readonly depthMeshes: boolean;
  readonly gpuBytes: number;
}

/** How a capture is used. */
export interface CaptureUse {
  /** The largest texture. */
  readonly maxSidePx: number;
  /** Whether its depth meshes are drawn. */
  readonly depthMeshes: boolean;
  /** What all of it may take on the GPU. Absent: only photographs have a limit. */
  readonly mostBytes?: number | undefined;
}

/**
 * The size of a capture on the GPU: its photographs, depth maps and meshes, and, if it has a limit, room for the weights of vertices. What
 * does not fit is left out in this order: the resolution of photographs, depth meshes, the whole mesh.
 *
 * @example
 * const { gpuBytes } = captureSize(document, { maxSidePx: 4096, depthMeshes: false });
 */
export function captureSize(document: CaptureDocument, { maxSidePx, depthMeshes: drawn, mostBytes }: CaptureUse): CaptureSize {
  const { views, mesh, coarseMesh } = document;
  const widthPx = Math.max(...views.map((view) => view.widthPx));
  const heightPx = Math.max(...views.map((view) => view.heightPx));
  const reduce = (scale: number) => [Math.max(1, Math.floor(widthPx * scale)), Math.max(1, Math.floor(heightPx * scale))] as const;
  const perVertex = VERTEX_BYTES + (mostBytes === undefined ? 0 : WEIGHT_BYTES);
  const bytesOf = (one: CaptureMeshFile, vertexBytes: number): number => one.vertexCount * vertexBytes + one.triangleCount * TRIANGLE_BYTES;
  const limit = mostBytes ?? Infinity;
  const wholeMesh = coarseMesh === undefined || bytesOf(mesh, perVertex) <= MOST_MESH * limit;
  const meshBytes = bytesOf(wholeMesh ? mesh : coarseMesh, perVertex);
  const sumOf = (bytes: (view: CaptureDocument['views'][number]) => number): number => views.reduce((sum, view) => sum + bytes(view), 0);
  const depthMeshBytes =
    sumOf(({ depthMesh }) => (depthMesh ? bytesOf(depthMesh, DEPTH_VERTEX_BYTES) : 0)) +
    sumOf(({ hiddenMesh }) => (hiddenMesh ? bytesOf(hiddenMesh, HIDDEN_VERTEX_BYTES) : 0));
  const depthMeshes = drawn && depthMeshBytes > 0 && meshBytes + depthMeshBytes <= MOST_MESHES * limit;
  const geometryBytes = meshBytes + (depthMeshes ? depthMeshBytes : 0) + (mostBytes === undefined ? 0 : VIEW_BYTES * views.length);
  const sizeAt = (scale: number) => {
    const photoPx = reduce(scale);
    const depthPx = reduce(Math.min(MAX_DEPTH_SIDE_PX, Math.max(...photoPx)) / Math.max(widthPx, heightPx));
    const perView = photoPx[0] * photoPx[1] * PHOTO_BYTES_PER_PIXEL + depthPx[0] * depthPx[1] * DEPTH_BYTES_PER_PIXEL;
    return { photoPx, depthPx, wholeMesh, depthMeshes, gpuBytes: Math.round(views.length * perView + geometryBytes) };
  };
  const photosFit = Math.sqrt(MAX_PHOTO_GPU_BYTES / (views.length * widthPx * heightPx * PHOTO_BYTES_PER_PIXEL));
  let scale = Math.min(1, photosFit, maxSidePx / Math.max(widthPx, heightPx));
  let size = sizeAt(scale);
  while (size.gpuBytes > limit && Math.max(...size.photoPx) > 1) {
    scale *= REDUCTION;
    size = sizeAt(scale);
  }
  return size;
}

/**
 * The size of a capture of a project on the GPU of a phone or headset, in a page of several files.
 *
 * @param document That of the project, which has no coarse mesh yet.
 * @param depthMeshes Whether its depth meshes are drawn.
 *
 * @example
 * const { photoPx, gpuBytes } = phoneCaptureSize(readCapture(text), false);
 */
export function phoneCaptureSize(document: CaptureDocument, depthMeshes: boolean): CaptureSize {
  const coarse = { file: '', triangleCount: COARSE_CAPTURE_TRIANGLES, vertexCount: COARSE_CAPTURE_TRIANGLES / 2 };
  const isCoarser = document.mesh.triangleCount >= 2 * COARSE_CAPTURE_TRIANGLES;
  const inPage = isCoarser ? { coarseMesh: coarse, ...document } : document;
  return captureSize(inPage, { maxSidePx: PHONE_TEXTURE_PX, depthMeshes, mostBytes: PHONE_CAPTURE_GPU_BYTES });
}

/**
 * What a capture of a project takes on the GPU of a phone or headset, in a page of several files.
 *
 * @example
 * const bytes = phoneCaptureBytes(readCapture(text), false);
 */
export function phoneCaptureBytes(document: CaptureDocument, depthMeshes: boolean): number {
  return phoneCaptureSize(document, depthMeshes).gpuBytes;
}
