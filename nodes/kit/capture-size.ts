import type { CaptureDocument, CaptureMeshFile } from './capture.ts';
import { PHONE_GPU_BYTES } from './phone-memory.ts';

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
  const { views, coarseMesh } = document;
  const widthPx = Math.max(...views.map((view) => view.widthPx));
  const heightPx = Math.max(...views.map((view) => view.heightPx));
  const reduce = (scale: number) => [Math.max(1, Math.floor(widthPx * scale)), Math.max(1, Math.floor(heightPx * scale))] as const;
  const limit = mostBytes ?? Infinity;
  const bytes = geometryBytes(document, mostBytes !== undefined);
  const wholeMesh = coarseMesh === undefined || bytes.mesh <= MOST_MESH * limit;
  const meshBytes = wholeMesh ? bytes.mesh : bytes.coarseMesh;
  const depthMeshes = drawn && bytes.depthMeshes > 0 && meshBytes + bytes.depthMeshes <= MOST_MESHES * limit;
  const fixedBytes = meshBytes + (depthMeshes ? bytes.depthMeshes : 0) + (mostBytes === undefined ? 0 : VIEW_BYTES * views.length);
  const sizeAt = (scale: number) => {
    const photoPx = reduce(scale);
    const depthPx = reduce(Math.min(MAX_DEPTH_SIDE_PX, Math.max(...photoPx)) / Math.max(widthPx, heightPx));
    const perView = photoPx[0] * photoPx[1] * PHOTO_BYTES_PER_PIXEL + depthPx[0] * depthPx[1] * DEPTH_BYTES_PER_PIXEL;
    return { photoPx, depthPx, wholeMesh, depthMeshes, gpuBytes: Math.round(views.length * perView + fixedBytes) };
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
 * The least limit at which nothing of a capture is left out on a phone or headset, bytes.
 *
 * @example
 * const needs = captureNeed(document, { maxSidePx: 4096, depthMeshes: false });
 */
export function captureNeed(document: CaptureDocument, use: Omit<CaptureUse, 'mostBytes'>): number {
  const { gpuBytes } = captureSize(document, { ...use, mostBytes: Infinity });
  const { mesh, depthMeshes } = geometryBytes(document, true);
  const forMesh = document.coarseMesh === undefined ? 0 : mesh / MOST_MESH;
  return Math.ceil(Math.max(gpuBytes, forMesh, use.depthMeshes ? (mesh + depthMeshes) / MOST_MESHES : 0));
}

/** What the meshes of a capture take; with a limit, room for the weights of vertices, too. */
function geometryBytes({ mesh, coarseMesh, views }: CaptureDocument, isLimited: boolean) {
  const perVertex = VERTEX_BYTES + (isLimited ? WEIGHT_BYTES : 0);
  const bytesOf = (one: CaptureMeshFile | undefined, vertexBytes: number): number =>
    one ? one.vertexCount * vertexBytes + one.triangleCount * TRIANGLE_BYTES : 0;
  const depthMeshes = views.map((view) => bytesOf(view.depthMesh, DEPTH_VERTEX_BYTES) + bytesOf(view.hiddenMesh, HIDDEN_VERTEX_BYTES));
  return {
    mesh: bytesOf(mesh, perVertex),
    coarseMesh: bytesOf(coarseMesh, perVertex),
    depthMeshes: depthMeshes.reduce((sum, bytes) => sum + bytes, 0),
  };
}

/**
 * The size of a capture of a project on the GPU of a phone or headset, in a page of several files.
 *
 * @param document That of the project, which has no coarse mesh yet.
 * @param depthMeshes Whether its depth meshes are drawn.
 * @param mostBytes Its share of the memory. Default: all of it.
 *
 * @example
 * const { gpuBytes } = phoneCaptureSize(readCapture(text), false);
 */
export function phoneCaptureSize(document: CaptureDocument, depthMeshes: boolean, mostBytes = PHONE_GPU_BYTES): CaptureSize {
  const coarse = { file: '', triangleCount: COARSE_CAPTURE_TRIANGLES, vertexCount: COARSE_CAPTURE_TRIANGLES / 2 };
  const isCoarser = document.mesh.triangleCount >= 2 * COARSE_CAPTURE_TRIANGLES;
  const inPage = isCoarser ? { coarseMesh: coarse, ...document } : document;
  return captureSize(inPage, { maxSidePx: PHONE_TEXTURE_PX, depthMeshes, mostBytes });
}
