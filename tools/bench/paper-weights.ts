import { depthFromMesh } from '../../export/captures/depth/depth-from-mesh.ts';
import type { CaptureMesh, Pinhole } from '../../nodes/kit/capture.ts';

/** Cameras of the same lens around a mesh. */
export interface PaperViews {
  readonly pinhole: Pinhole;
  readonly poses: readonly (readonly number[])[];
  /** Depth along the axis of each camera, rows from the top; 0 where nothing is. */
  readonly depths: readonly Float32Array[];
}

/** Photographs per vertex, the share of the resolution in a cost, the margin of a picture, and the tolerance of depth: defaults of COLIBRI VR. */
const [BLENDED, RESOLUTION, MARGIN, TOLERANCE] = [2, 0.2, 0.01, 0.1];

export function paperViews(mesh: CaptureMesh, pinhole: Pinhole, poses: readonly (readonly number[])[]): PaperViews {
  return { pinhole, poses, depths: poses.map((pose) => depthFromMesh(mesh, pinhole, pose).values) };
}

/**
 * The loop of “From Real to Virtual” (COLIBRI VR) over all vertices and all cameras, ported to one thread of JavaScript.
 *
 * @param normals Directions with three numbers per vertex, and a fourth that is not used.
 * @returns Sum of all weights, which is the number of vertices that a photograph sees.
 */
export function paperWeights(
  { positions }: CaptureMesh,
  normals: Int8Array,
  { pinhole, poses, depths }: PaperViews,
  eye: readonly number[],
): number {
  const [ex = 0, ey = 0, ez = 0] = eye;
  const costs = new Float64Array(BLENDED + 1);
  let total = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = [positions[i], positions[i + 1], positions[i + 2]];
    const normal = (4 * i) / 3;
    const eyeM = Math.hypot(ex - x, ey - y, ez - z);
    costs.fill(Number.POSITIVE_INFINITY);
    for (let camera = 0; camera < poses.length; camera++) {
      const m = poses[camera] ?? [];
      const [dx, dy, dz] = [(m[12] ?? 0) - x, (m[13] ?? 0) - y, (m[14] ?? 0) - z];
      if (dx * (normals[normal] ?? 0) + dy * (normals[normal + 1] ?? 0) + dz * (normals[normal + 2] ?? 0) <= 0) continue;
      if (!isSeen(m, depths[camera] ?? new Float32Array(), pinhole, dx, dy, dz)) continue;
      const cameraM = Math.hypot(dx, dy, dz);
      const angle = Math.acos(Math.min(1, (dx * (ex - x) + dy * (ey - y) + dz * (ez - z)) / (cameraM * eyeM)));
      const cost = ((1 - RESOLUTION) * angle) / Math.PI + RESOLUTION * Math.max(0, 1 - eyeM / cameraM);
      for (let at = BLENDED; at >= 0 && cost < (costs[at] ?? 0); at--) {
        if (at < BLENDED) costs[at + 1] = costs[at] ?? 0;
        costs[at] = cost;
      }
    }
    const threshold = Math.min(1, costs[BLENDED] ?? 1);
    let sum = 0;
    for (let at = 0; at < BLENDED; at++) sum += Math.max(0, 1 - (costs[at] ?? 0) / threshold);
    if (sum > 0) total += 1;
  }
  return total;
}

/** Whether all of 3 × 3 depths agree with the point; dx, dy and dz lead from it to the camera. */
function isSeen(
  m: readonly number[],
  depths: Float32Array,
  { widthPx, heightPx, fxPx, fyPx, cxPx, cyPx }: Pinhole,
  dx: number,
  dy: number,
  dz: number,
): boolean {
  const along = (axis: number): number => -(dx * (m[4 * axis] ?? 0) + dy * (m[4 * axis + 1] ?? 0) + dz * (m[4 * axis + 2] ?? 0));
  const depth = -along(2);
  if (depth <= 0) return false;
  const column = (fxPx * along(0)) / depth + cxPx;
  const row = (-fyPx * along(1)) / depth + cyPx;
  const [marginX, marginY] = [MARGIN * widthPx, MARGIN * heightPx];
  if (column < marginX || column > widthPx - marginX || row < marginY || row > heightPx - marginY) return false;
  for (let down = -1; down <= 1; down++) {
    for (let right = -1; right <= 1; right++) {
      const atColumn = Math.min(Math.max(Math.floor(column) + right, 0), widthPx - 1);
      const atRow = Math.min(Math.max(Math.floor(row) + down, 0), heightPx - 1);
      const found = depths[atRow * widthPx + atColumn] ?? 0;
      if (found > 0 && Math.abs(found / depth - 1) > TOLERANCE) return false;
    }
  }
  return true;
}
