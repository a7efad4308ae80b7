import type { CaptureMesh, Pinhole } from '../../../nodes/kit/capture.ts';
import type { DepthMap } from './depth-map.ts';
import { panoramaRays } from './depth-rays.ts';

/** Points nearer than this share of a unit to the plane of the camera are cut off. */
const NEAR = 1e-3;
/** Triangles are larger by this share of their size, so that rounding leaves no pixel between two of them. */
const EDGE = 1e-4;

/**
 * Draws the depth of a mesh along the axis of a camera. Mesh and pose have the same unit, which is that of the depths.
 *
 * @param worldFromCamera Column-major 4×4; the camera looks along −z.
 */
export function depthFromMesh({ positions, indices }: CaptureMesh, pinhole: Pinhole, worldFromCamera: readonly number[]): DepthMap {
  const { widthPx, heightPx } = pinhole;
  const inverse = new Float64Array(widthPx * heightPx);
  const seen = inCameraSpace(positions, worldFromCamera);
  const polygon = new Float64Array(12);
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const corners = clipAtNear(seen, indices, i, polygon);
    for (let corner = 0; corner < corners; corner++) {
      const [x, y, z] = [polygon[3 * corner] ?? 0, polygon[3 * corner + 1] ?? 0, polygon[3 * corner + 2] ?? 0];
      polygon[3 * corner] = (pinhole.fxPx * x) / z + pinhole.cxPx;
      polygon[3 * corner + 1] = (pinhole.fyPx * y) / z + pinhole.cyPx;
      polygon[3 * corner + 2] = 1 / z;
    }
    for (let corner = 1; corner + 1 < corners; corner++) fill(inverse, widthPx, heightPx, polygon, corner);
  }
  return { widthPx, heightPx, values: new Float32Array(inverse.map((value) => (value > 0 ? 1 / value : 0))) };
}

/** x to the right, y down and the depth of each vertex. */
function inCameraSpace(positions: Float32Array, m: readonly number[]): Float64Array {
  const at = (i: number): number => m[i] ?? 0;
  const seen = new Float64Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const x = (positions[i] ?? 0) - at(12);
    const y = (positions[i + 1] ?? 0) - at(13);
    const z = (positions[i + 2] ?? 0) - at(14);
    seen[i] = x * at(0) + y * at(1) + z * at(2);
    seen[i + 1] = -(x * at(4) + y * at(5) + z * at(6));
    seen[i + 2] = -(x * at(8) + y * at(9) + z * at(10));
  }
  return seen;
}

/** Writes the part of a triangle in front of the camera to `out`. Returns its number of corners: 0, 3 or 4. */
function clipAtNear(seen: Float64Array, indices: Uint32Array, first: number, out: Float64Array): number {
  let count = 0;
  for (let corner = 0; corner < 3; corner++) {
    const from = 3 * (indices[first + corner] ?? 0);
    const to = 3 * (indices[first + ((corner + 1) % 3)] ?? 0);
    const [za, zb] = [seen[from + 2] ?? 0, seen[to + 2] ?? 0];
    if (za >= NEAR) {
      for (let axis = 0; axis < 3; axis++) out[3 * count + axis] = seen[from + axis] ?? 0;
      count++;
    }
    if (za >= NEAR === zb >= NEAR) continue;
    const part = (NEAR - za) / (zb - za);
    for (let axis = 0; axis < 3; axis++) {
      const [a, b] = [seen[from + axis] ?? 0, seen[to + axis] ?? 0];
      out[3 * count + axis] = a + (b - a) * part;
    }
    count++;
  }
  return count;
}

/** Fills the triangle of the corners 0, `corner` and `corner + 1` of a polygon with the largest inverse depth of each pixel center. */
function fill(inverse: Float64Array, widthPx: number, heightPx: number, polygon: Float64Array, corner: number): void {
  const of = (i: number): number => polygon[i] ?? 0;
  const next = 3 * corner;
  const [ax, ay, az, bx, by, bz] = [of(0), of(1), of(2), of(next), of(next + 1), of(next + 2)];
  const [cx, cy, cz] = [of(next + 3), of(next + 4), of(next + 5)];
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area === 0 || !Number.isFinite(area)) return;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
  const right = Math.min(widthPx - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
  const bottom = Math.min(heightPx - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  for (let row = top; row <= bottom; row++) {
    const y = row + 0.5;
    for (let column = left; column <= right; column++) {
      const x = column + 0.5;
      const b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area;
      const c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area;
      if (b < -EDGE || c < -EDGE || b + c > 1 + EDGE) continue;
      const value = az + b * (bz - az) + c * (cz - az);
      const at = row * widthPx + column;
      if (value > (inverse[at] ?? 0)) inverse[at] = value;
    }
  }
}

/** Draws the depth of a mesh along the axis of a pinhole camera, or its distance from a 360° camera. */
export function depthSeen(mesh: CaptureMesh, camera: Pinhole, worldFromCamera: readonly number[]): DepthMap {
  if (camera.projection === undefined) return depthFromMesh(mesh, camera, worldFromCamera);
  return distanceFromMesh(mesh, camera.widthPx, camera.heightPx, worldFromCamera);
}

/** The camera axes right, up and backward of the six faces of a cube, in those of the camera. */
const FACES = [
  [1, 0, 0, 0, 1, 0, 0, 0, 1],
  [0, 0, -1, 0, 1, 0, 1, 0, 0],
  [0, 0, 1, 0, 1, 0, -1, 0, 0],
  [-1, 0, 0, 0, 1, 0, 0, 0, -1],
  [1, 0, 0, 0, 0, 1, 0, -1, 0],
  [1, 0, 0, 0, 0, -1, 0, 1, 0],
] as const;

/** Draws the distance of a mesh from a camera in all directions, as an equirectangular map, by the faces of a cube. */
function distanceFromMesh(mesh: CaptureMesh, widthPx: number, heightPx: number, worldFromCamera: readonly number[]): DepthMap {
  const sidePx = Math.ceil(widthPx / 2);
  const face = { widthPx: sidePx, heightPx: sidePx, fxPx: sidePx / 2, fyPx: sidePx / 2, cxPx: sidePx / 2, cyPx: sidePx / 2 };
  const { across, ahead, level, down } = panoramaRays(widthPx, heightPx);
  const values = new Float32Array(widthPx * heightPx);
  for (const axes of FACES) {
    const drawn = depthFromMesh(mesh, face, turned(worldFromCamera, axes));
    for (let i = 0; i < values.length; i++) {
      const [column, row] = [i % widthPx, Math.floor(i / widthPx)];
      const [x, y, z] = [(across[column] ?? 0) * (level[row] ?? 0), -(down[row] ?? 0), -(ahead[column] ?? 0) * (level[row] ?? 0)];
      const along = (axis: number): number => x * (axes[3 * axis] ?? 0) + y * (axes[3 * axis + 1] ?? 0) + z * (axes[3 * axis + 2] ?? 0);
      const depth = -along(2);
      const [u, v] = [along(0) / depth, -along(1) / depth];
      if (depth <= 0 || Math.abs(u) > 1 || Math.abs(v) > 1) continue;
      const at = (half: number): number => Math.min(sidePx - 1, Math.floor(((half + 1) / 2) * sidePx));
      values[i] = (drawn.values[at(v) * sidePx + at(u)] ?? 0) / depth;
    }
  }
  return { widthPx, heightPx, values };
}

/** A pose whose axes are `axes` in those of another pose, at the same place. */
function turned(pose: readonly number[], axes: readonly number[]): readonly number[] {
  const columns = [0, 1, 2].map((axis) =>
    [0, 1, 2, 3].map((row) => [0, 1, 2].reduce((sum, i) => sum + (axes[3 * axis + i] ?? 0) * (pose[4 * i + row] ?? 0), 0)),
  );
  return [...columns.flat(), ...pose.slice(12)];
}
