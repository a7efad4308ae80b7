import type { VoxelSettings } from '../../kit/physics.ts';
import { indexIn, type VoxelChunks } from './voxel-chunks.ts';

/**
 * Parts of the threshold between which the points of a voxel lose their share. Beside an occupied voxel also others count, because
 * those that come and go with the noise of a sensor would shake what lies on them.
 */
const FADE_START = 0.5;
const FADE_END = 0.2;
/** Radius within which measured points have weight, in edges of a voxel. */
const KERNEL = 0.7;

/**
 * A smooth surface through the occupied voxels, computed on demand. Its signed distance at the middle of a voxel is the mean of the
 * distances from the planes that were measured in the 27 voxels around (“Provably Good Moving Least Squares”, 2008); its vertices are those
 * of surface nets (Gibson, “Constrained Elastic Surface Nets”, 1998).
 */
export interface SurfaceField {
  /** The height above the surface at the center of a voxel, meters; negative below, NaN where nothing was measured around it. */
  at(vx: number, vy: number, vz: number): number;
  /**
   * Writes the vertex of the surface in the cell between the centers of a voxel and its seven next ones. Returns false if the surface does
   * not pass through the cell.
   */
  vertex(vx: number, vy: number, vz: number, out: Float64Array, offset: number): boolean;
  /** The height above the surface at a point, meters, and its gradient; NaN where unknown. */
  sample(x: number, y: number, z: number, gradient: Float64Array | null): number;
  /** Marks computed distances as outdated. Call it when voxels have changed. */
  invalidate(): void;
}

// Filled and read within one call.
const corners = new Float64Array(8);

export function createSurfaceField(chunks: VoxelChunks, { edgeM, threshold }: VoxelSettings): SurfaceField {
  let version = 1;
  const falloff = -1 / (KERNEL * edgeM) ** 2;

  function compute(vx: number, vy: number, vz: number): number {
    const x = (vx + 0.5) * edgeM;
    const y = (vy + 0.5) * edgeM;
    const z = (vz + 0.5) * edgeM;
    let sum = 0;
    let weights = 0;
    let most = 0;
    const own = isInner(vx) && isInner(vy) && isInner(vz) ? chunks.of(vx, vy, vz) : null;
    if (own === undefined) return Number.NaN;
    for (let i = vx - 1; i <= vx + 1; i++) {
      for (let j = vy - 1; j <= vy + 1; j++) {
        for (let k = vz - 1; k <= vz + 1; k++) {
          const chunk = own ?? chunks.of(i, j, k);
          if (!chunk?.surface) continue;
          const index = indexIn(i, j, k);
          const occupancy = (chunk.weights[index] ?? 0) / threshold;
          most = Math.max(most, occupancy);
          const share = Math.min((occupancy - FADE_END) / (FADE_START - FADE_END), 1);
          if (share <= 0) continue;
          const { points, normals, rates } = chunk.surface;
          const o = 3 * index;
          const dx = x - (points[o] ?? 0);
          const dy = y - (points[o + 1] ?? 0);
          const dz = z - (points[o + 2] ?? 0);
          const nx = normals[o] ?? 0;
          const ny = normals[o + 1] ?? 0;
          const nz = normals[o + 2] ?? 0;
          const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
          if (length < 1e-6) continue;
          const weight = share * (rates[index] ?? 0) * Math.exp(falloff * (dx * dx + dy * dy + dz * dz));
          sum += (weight * (nx * dx + ny * dy + nz * dz)) / length;
          weights += weight;
        }
      }
    }
    return most >= 1 && weights > 0 ? sum / weights : Number.NaN;
  }
  function at(vx: number, vy: number, vz: number): number {
    const surface = chunks.of(vx, vy, vz)?.surface;
    if (!surface) return compute(vx, vy, vz);
    const index = indexIn(vx, vy, vz);
    if (surface.fieldFrames[index] !== version) {
      surface.fieldFrames[index] = version;
      surface.field[index] = compute(vx, vy, vz);
    }
    return surface.field[index] ?? Number.NaN;
  }
  /** Reads the distances at the eight corners of a cell. Returns false if one is unknown. */
  function readCorners(vx: number, vy: number, vz: number): boolean {
    for (let k = 0; k < 8; k++) {
      const value = at(vx + (k & 1), vy + ((k >> 1) & 1), vz + (k >> 2));
      if (Number.isNaN(value)) return false;
      corners[k] = value;
    }
    return true;
  }
  /** Writes the mean of the points where the surface crosses the edges of a cell, which is the cell's vertex. */
  function computeVertex(vx: number, vy: number, vz: number, out: Float32Array | Float64Array, o: number): boolean {
    out[o] = Number.NaN;
    if (!readCorners(vx, vy, vz)) return false;
    let [x, y, z, count] = [0, 0, 0, 0];
    for (let axis = 0; axis < 3; axis++) {
      const bit = 1 << axis;
      for (let k = 0; k < 8; k++) {
        if (k & bit) continue;
        const a = corners[k] ?? 0;
        const b = corners[k | bit] ?? 0;
        if (a < 0 === b < 0) continue;
        const t = a / (a - b);
        x += axis === 0 ? t : k & 1;
        y += axis === 1 ? t : (k >> 1) & 1;
        z += axis === 2 ? t : k >> 2;
        count++;
      }
    }
    if (count === 0) return false;
    out[o] = (vx + 0.5 + x / count) * edgeM;
    out[o + 1] = (vy + 0.5 + y / count) * edgeM;
    out[o + 2] = (vz + 0.5 + z / count) * edgeM;
    return true;
  }

  return {
    at,
    vertex: (vx, vy, vz, out, offset) => {
      const surface = chunks.of(vx, vy, vz)?.surface;
      if (!surface) return computeVertex(vx, vy, vz, out, offset);
      const index = indexIn(vx, vy, vz);
      const o = 3 * index;
      if (surface.vertexFrames[index] !== version) {
        surface.vertexFrames[index] = version;
        computeVertex(vx, vy, vz, surface.vertices, o);
      }
      const x = surface.vertices[o] ?? Number.NaN;
      if (Number.isNaN(x)) return false;
      out[offset] = x;
      out[offset + 1] = surface.vertices[o + 1] ?? 0;
      out[offset + 2] = surface.vertices[o + 2] ?? 0;
      return true;
    },
    sample: (x, y, z, gradient) => {
      const px = x / edgeM - 0.5;
      const py = y / edgeM - 0.5;
      const pz = z / edgeM - 0.5;
      const [vx, vy, vz] = [Math.floor(px), Math.floor(py), Math.floor(pz)];
      if (!readCorners(vx, vy, vz)) return Number.NaN;
      const [u, v, w] = [px - vx, py - vy, pz - vz];
      let value = 0;
      let [gx, gy, gz] = [0, 0, 0];
      for (let k = 0; k < 8; k++) {
        const c = corners[k] ?? 0;
        const a = k & 1 ? u : 1 - u;
        const b = k & 2 ? v : 1 - v;
        const d = k & 4 ? w : 1 - w;
        value += a * b * d * c;
        gx += (k & 1 ? 1 : -1) * b * d * c;
        gy += (k & 2 ? 1 : -1) * a * d * c;
        gz += (k & 4 ? 1 : -1) * a * b * c;
      }
      if (gradient) {
        gradient[0] = gx / edgeM;
        gradient[1] = gy / edgeM;
        gradient[2] = gz / edgeM;
      }
      return value;
    },
    invalidate: () => {
      version++;
    },
  };
}

/** Whether both neighbors of a voxel along an axis lie in the same chunk. */
function isInner(v: number): boolean {
  return (v & 7) > 0 && (v & 7) < 7;
}
