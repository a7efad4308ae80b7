import { emptyVoxels, MAX_FILE_VOXELS, type VoxelFile } from '../../kit/voxel-file.ts';
import { type Chunk, indexIn, SIDE, VOXELS, type VoxelChunks } from './voxel-chunks.ts';

/** How many hits the means of a voxel count as that comes from a file: new measurements soon outweigh it. */
const FILE_HITS = 30;

/** Copies the occupied voxels, those with at least the weight `threshold`; at most as many as a file holds. */
export function saveVoxels(chunks: VoxelChunks, edgeM: number, threshold: number): VoxelFile {
  let count = 0;
  for (const { weights } of chunks.all()) for (let i = 0; i < VOXELS; i++) if ((weights[i] ?? 0) >= threshold) count++;
  const out = emptyVoxels(edgeM, Math.min(count, MAX_FILE_VOXELS));
  let n = 0;
  for (const chunk of chunks.all()) {
    for (let i = 0; i < VOXELS && n < out.count; i++) if ((chunk.weights[i] ?? 0) >= threshold) saveVoxel(chunk, i, out, n++);
  }
  return out;
}

function saveVoxel({ x, y, z, weights, seen, surface }: Chunk, index: number, out: VoxelFile, n: number): void {
  const o = 3 * index;
  out.weights[n] = Math.round(255 * Math.min(weights[index] ?? 0, 1));
  for (let axis = 0; axis < 3; axis++) {
    const cell = (axis === 0 ? x : axis === 1 ? y : z) * SIDE + ((index >> (3 * axis)) & 7);
    out.indices[3 * n + axis] = cell;
    out.seen[3 * n + axis] = Math.round(127 * clamp(seen[o + axis] ?? 0, -1));
    const part = surface ? (surface.points[o + axis] ?? 0) / out.edgeM - cell : 0.5;
    out.points[3 * n + axis] = Math.round(255 * clamp(part, 0));
    out.normals[3 * n + axis] = surface ? Math.round(127 * clamp(surface.normals[o + axis] ?? 0, -1)) : 0;
  }
}

/**
 * Adds voxels to chunks whose edge is `edgeM`. A voxel becomes occupied if its middle lies in one of them, so that a surface stays one
 * voxel thick and has no holes.
 *
 * @param worldFromFile Rigid, column-major 4×4: from the space of the voxels to world space.
 */
export function loadVoxels(chunks: VoxelChunks, edgeM: number, voxels: VoxelFile, worldFromFile: ArrayLike<number>): void {
  const m = (i: number): number => worldFromFile[i] ?? 0;
  const { indices, weights, seen, points, normals, count } = voxels;
  const e = voxels.edgeM;
  // As many voxels around the middle as its cube may reach.
  const reach = Math.ceil((0.87 * e) / edgeM);
  const place = (x: number, y: number, z: number, row: number): number => m(row) * x + m(4 + row) * y + m(8 + row) * z;
  for (let n = 0; n < count; n++) {
    const k = 3 * n;
    const [i, j, l] = [indices[k] ?? 0, indices[k + 1] ?? 0, indices[k + 2] ?? 0];
    const [mx, my, mz] = [(i + 0.5) * e, (j + 0.5) * e, (l + 0.5) * e];
    const cx = Math.floor((place(mx, my, mz, 0) + m(12)) / edgeM);
    const cy = Math.floor((place(mx, my, mz, 1) + m(13)) / edgeM);
    const cz = Math.floor((place(mx, my, mz, 2) + m(14)) / edgeM);
    for (let vx = cx - reach; vx <= cx + reach; vx++) {
      for (let vy = cy - reach; vy <= cy + reach; vy++) {
        for (let vz = cz - reach; vz <= cz + reach; vz++) {
          const dx = (vx + 0.5) * edgeM - m(12);
          const dy = (vy + 0.5) * edgeM - m(13);
          const dz = (vz + 0.5) * edgeM - m(14);
          // In the space of the file: the inverse of a rotation is its transpose.
          if (Math.floor((m(0) * dx + m(1) * dy + m(2) * dz) / e) !== i) continue;
          if (Math.floor((m(4) * dx + m(5) * dy + m(6) * dz) / e) !== j) continue;
          if (Math.floor((m(8) * dx + m(9) * dy + m(10) * dz) / e) !== l) continue;
          const chunk = chunks.make(vx, vy, vz);
          if (!chunk) return;
          fill(chunk, indexIn(vx, vy, vz), k);
        }
      }
    }
  }
  function fill({ weights: to, seen: toSeen, surface }: Chunk, index: number, k: number): void {
    const o = 3 * index;
    to[index] = (weights[k / 3] ?? 0) / 255;
    const part = (axis: number): number => ((indices[k + axis] ?? 0) + (points[k + axis] ?? 0) / 255) * e;
    const [px, py, pz] = [part(0), part(1), part(2)];
    for (let row = 0; row < 3; row++) {
      toSeen[o + row] = place(seen[k] ?? 0, seen[k + 1] ?? 0, seen[k + 2] ?? 0, row) / 127;
      if (!surface) continue;
      surface.points[o + row] = place(px, py, pz, row) + m(12 + row);
      surface.normals[o + row] = place(normals[k] ?? 0, normals[k + 1] ?? 0, normals[k + 2] ?? 0, row) / 127;
    }
    if (!surface) return;
    surface.counts[index] = FILE_HITS;
    surface.rates[index] = 1;
  }
}

function clamp(value: number, least: number): number {
  return Math.min(Math.max(value, least), 1);
}
