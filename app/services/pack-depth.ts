import { encode as encodePng } from 'fast-png';
import { depthSeen } from '../../export/captures/depth/depth-from-mesh.ts';
import { type DepthMap, isKnown, scaledPinhole } from '../../export/captures/depth/depth-map.ts';
import { type DepthMesh, makeDepthMesh } from '../../export/captures/depth/depth-mesh.ts';
import { raysOf } from '../../export/captures/depth/depth-rays.ts';
import type { FusedView } from '../../export/captures/depth/fuse-depth-meshes.ts';
import { hiddenSurface } from '../../export/captures/depth/hidden-surface.ts';
import { thinDepthMesh } from '../../export/captures/depth/thin-depth-mesh.ts';
import type { Photo } from '../../export/captures/undistort.ts';
import { CAPTURE_LIMITS, type CaptureMesh, type CaptureView, MOST_DEPTH_TRIANGLES, type Pinhole } from '../../nodes/kit/capture.ts';

/** The files of the depth of one view by their names, and what its document says of them. */
export interface PackedDepth {
  readonly files: readonly (readonly [name: string, content: Uint8Array])[];
  readonly members: Pick<CaptureView, 'depth' | 'depthMesh' | 'hiddenMesh'>;
  /** The depth mesh, to be joined with those of other views; null without it. */
  readonly fused: FusedView | null;
}

/** Depth that is drawn from the mesh of a place has at most this longest side: finer edges are those of the mesh, not of the place. */
const MAX_DRAWN_SIDE_PX = 1024;
/** A depth mesh has at most this many triangles, which are less than a tenth of a map of 1,024 × 768 pixels. */
const MAX_TRIANGLES = 150_000;
const MAX_TRIANGLES_AROUND = 400_000;
/** What is hidden behind near things is smooth. */
const HIDDEN_TOLERANCE = 0.02;
const MAX_HIDDEN_TRIANGLES = 60_000;
/** Depths beyond this are stored as unknown, so that 16 bits resolve the others, meters. */
const MOST_DEPTH_M = 1000;
const LEVELS = 65535;
/** All depth meshes together may become the mesh of the place. */
const MOST_TRIANGLES = Math.min(MOST_DEPTH_TRIANGLES, CAPTURE_LIMITS.triangles);

/**
 * Packs the depth map of a view, if there is one, and its depth mesh.
 *
 * @param map Depth in meters; null: it is drawn from `mesh`.
 * @param mesh The mesh of the place in meters; null: no depth mesh is made without a map.
 * @param photo The photograph, to paint what it does not show; null: nothing does.
 * @param viewCount Number of views that share the limit of triangles.
 */
export function packDepthFiles(
  map: DepthMap | null,
  mesh: CaptureMesh | null,
  photo: Photo | null,
  pinhole: Pinhole,
  worldFromCamera: readonly number[],
  index: number,
  viewCount: number,
): PackedDepth {
  const number = String(index).padStart(3, '0');
  const files: [string, Uint8Array][] = [];
  let members: PackedDepth['members'] = {};
  if (map) {
    const { widthPx, heightPx } = map;
    const { bytes, metersPerLevel } = packMap(map);
    files.push([`depths/${number}.png`, bytes]);
    members = { depth: { file: `depths/${number}.png`, widthPx, heightPx, metersPerLevel } };
  }
  const factor = map ? map.widthPx / pinhole.widthPx : Math.min(1, MAX_DRAWN_SIDE_PX / Math.max(pinhole.widthPx, pinhole.heightPx));
  const camera = scaledPinhole(pinhole, factor);
  const seen = map ?? (mesh && depthSeen(mesh, camera, worldFromCamera));
  if (!seen) return { files, members, fused: null };
  const most = camera.projection === undefined ? MAX_TRIANGLES : MAX_TRIANGLES_AROUND;
  const rays = raysOf(camera);
  const made = makeDepthMesh(seen, rays, Math.min(most, Math.floor(MOST_TRIANGLES / viewCount)));
  if (made.indices.length === 0) return { files, members, fused: null };
  const thin = thinDepthMesh(made, seen, rays);
  const file = `depth-meshes/${number}.bin`;
  files.push([file, meshBytes(thin)]);
  const counts = { vertexCount: thin.depths.length, triangleCount: thin.indices.length / 3 };
  const depthMesh = { file, widthPx: seen.widthPx, heightPx: seen.heightPx, ...counts };
  members = { ...members, depthMesh };
  const share = Math.min(MAX_HIDDEN_TRIANGLES, Math.floor((MOST_DEPTH_TRIANGLES - MOST_TRIANGLES) / viewCount));
  const hidden = photo && packHidden(seen, camera, photo, share);
  if (hidden) {
    const { bytes, ...hiddenCounts } = hidden;
    const hiddenMesh = { file: `hidden-meshes/${number}.bin`, widthPx: seen.widthPx, heightPx: seen.heightPx, ...hiddenCounts };
    files.push([hiddenMesh.file, bytes]);
    members = { ...members, hiddenMesh };
  }
  return { files, members, fused: { made, map: seen, camera, worldFromCamera } };
}

/** The mesh of what a photograph does not show, with colors; null if nothing is hidden. */
function packHidden(map: DepthMap, camera: Pinhole, photo: Photo, most: number) {
  const { widthPx, heightPx } = map;
  const rays = raysOf(camera);
  const found = hiddenSurface(map, rays, colorsFor(photo, widthPx, heightPx), camera.fxPx);
  const made = makeDepthMesh(found.map, rays, most, HIDDEN_TOLERANCE);
  const vertexCount = made.depths.length;
  if (made.indices.length === 0) return null;
  const colors = new Uint8Array(4 * vertexCount);
  for (let i = 0; i < vertexCount; i++) {
    const [x, y] = [((made.places[2 * i] ?? 1) - 1) / 2, ((made.places[2 * i + 1] ?? 1) - 1) / 2];
    const at = 4 * (y * widthPx + x);
    colors.set(found.colors.subarray(at, at + 4), 4 * i);
  }
  return { bytes: Buffer.concat([meshBytes(made), colors]), vertexCount, triangleCount: made.indices.length / 3 };
}

/** The photograph in the size of a depth map: the pixel in the middle of each. */
function colorsFor({ widthPx, heightPx, data }: Photo, width: number, height: number): Uint8Array {
  const colors = new Uint8Array(4 * width * height);
  for (let row = 0; row < height; row++) {
    const from = Math.floor(((row + 0.5) * heightPx) / height) * widthPx;
    for (let column = 0; column < width; column++) {
      const at = 4 * (from + Math.floor(((column + 0.5) * widthPx) / width));
      colors.set(data.subarray(at, at + 4), 4 * (row * width + column));
    }
  }
  return colors;
}

function packMap({ widthPx, heightPx, values }: DepthMap): { readonly bytes: Uint8Array; readonly metersPerLevel: number } {
  const isStored = (depth: number): boolean => isKnown(depth) && depth <= MOST_DEPTH_M;
  let most = 0;
  for (const depth of values) if (isStored(depth) && depth > most) most = depth;
  const metersPerLevel = most / LEVELS || 0.001;
  // `Uint16Array.from` would first make an array of objects.
  const data = new Uint16Array(values.length);
  for (let i = 0; i < data.length; i++) {
    const depth = values[i] ?? 0;
    if (isStored(depth)) data[i] = Math.max(1, Math.round(depth / metersPerLevel));
  }
  return { bytes: encodePng({ width: widthPx, height: heightPx, data, depth: 16, channels: 1 }), metersPerLevel };
}

function meshBytes({ places, depths, indices }: DepthMesh): Uint8Array {
  const bytes = new Uint8Array(8 * depths.length + 4 * indices.length);
  const view = new DataView(bytes.buffer);
  depths.forEach((depth, i) => {
    view.setUint16(8 * i, places[2 * i] ?? 0, true);
    view.setUint16(8 * i + 2, places[2 * i + 1] ?? 0, true);
    view.setFloat32(8 * i + 4, depth, true);
  });
  new Uint32Array(bytes.buffer, 8 * depths.length).set(indices);
  return bytes;
}

/** How far the floor is below a 360° camera: the middle of the depths in the last rows. */
export function heightAboveFloorM({ widthPx, heightPx, values }: DepthMap): number | null {
  const below = values
    .subarray(widthPx * Math.floor(heightPx * 0.98))
    .filter(isKnown)
    .sort();
  return below[below.length >> 1] ?? null;
}
