import type { DepthFrame, VoxelSettings } from '../../kit/physics.ts';
import type { VoxelFile } from '../../kit/voxel-file.ts';
import { createSurfaceField, type SurfaceField } from './surface-field.ts';
import { writeNormal } from './texel-normal.ts';
import { type Chunk, createVoxelChunks, indexIn, keyOf, SIDE, VOXELS } from './voxel-chunks.ts';
import { loadVoxels, saveVoxels } from './voxel-transfer.ts';

/** Voxels of less weight count as never seen. */
const GONE = 0.01;
/** The number of hits over which a voxel's means run: those of about a second, so that bodies rest steadily on it. */
const MEAN_HITS = 255;
/** Time constant of the mean number of points of a voxel. With less, the noise of a sensor shakes bodies that rest. */
const SLOW_S = 3;
/** From the center of a voxel to its corners, in edges. */
const MOST_REACH = 0.87;
/** Rays through a voxel that are tested along each axis of the image. */
const MAX_RAYS = 8;

/**
 * A probabilistic voxel grid of the surfaces that depth shows. Each depth frame updates the weight V of each voxel once: V' = V · (1 − U) +
 * U · H, where U is the speed and H is 1 for a hit, 0 for a miss. A voxel outside the view, or behind what is measured, keeps its weight.
 */
export interface VoxelGrid {
  readonly settings: VoxelSettings;
  update(frame: DepthFrame): void;
  /** Copies the occupied voxels. */
  save(): VoxelFile;
  /** Replaces all voxels. `worldFromFile` is rigid, column-major 4×4. */
  load(voxels: VoxelFile, worldFromFile: ArrayLike<number>): void;
  isOccupied(x: number, y: number, z: number): boolean;
  weightAt(x: number, y: number, z: number): number;
  /** Whether a direction leaves the voxel towards a side from which it was seen. */
  isOutward(x: number, y: number, z: number, dx: number, dy: number, dz: number): boolean;
  /** Whether the last update has made a voxel in a box occupied or free. The box is in world space, meters. */
  hasChanged(minX: number, minY: number, minZ: number, maxX: number, maxY: number, maxZ: number): boolean;
  /** Calls back with the indices of all occupied voxels. */
  forEachOccupied(call: (x: number, y: number, z: number) => void): void;
  /** The smooth surface; null where bodies collide with the voxels themselves. */
  readonly surface: SurfaceField | null;
  /** The number of voxels that the last update has read or written. */
  readonly touched: number;
  readonly chunkCount: number;
  /** The height below which no voxel is occupied, meters; infinite if none is occupied at all. */
  readonly lowestM: number;
}

// Filled and read within one call.
const scratchNormal = new Float64Array(3);

export function createVoxelGrid(settings: VoxelSettings): VoxelGrid {
  const { edgeM, threshold, speed, farM, isSmooth = false } = settings;
  const chunks = createVoxelChunks(isSmooth);
  const changed = new Set<number>();
  const surface = isSmooth ? createSurfaceField(chunks, settings) : null;
  let frameIndex = 0;
  let touched = 0;
  let lowestM = Number.POSITIVE_INFINITY;

  function setWeight(chunk: Chunk, index: number, weight: number): void {
    const before = chunk.weights[index] ?? 0;
    chunk.weights[index] = weight;
    if (before >= threshold === weight >= threshold) return;
    changed.add(keyOf(chunk.x * SIDE + (index & 7), chunk.y * SIDE + ((index >> 3) & 7), chunk.z * SIDE + (index >> 6)));
  }
  function weightAt(x: number, y: number, z: number): number {
    return chunks.of(x, y, z)?.weights[indexIn(x, y, z)] ?? 0;
  }

  function addHits(frame: DepthFrame, rate: number, slow: number): void {
    const { meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r } = frame;
    const [r0, r1, r2, r3, r4, r5] = [at(r, 0), at(r, 1), at(r, 2), at(r, 3), at(r, 4), at(r, 5)];
    const [m0, m1, m2, m4, m5, m6] = [at(m, 0), at(m, 1), at(m, 2), at(m, 4), at(m, 5), at(m, 6)];
    const [m8, m9, m10, ox, oy, oz] = [at(m, 8), at(m, 9), at(m, 10), at(m, 12), at(m, 13), at(m, 14)];
    for (let j = 0; j < heightPx; j++) {
      for (let i = 0; i < widthPx; i++) {
        const d = meters[j * widthPx + i] ?? 0;
        if (!(d > 0 && d < farM)) continue;
        const x = (r0 * i + r1 * j + r2) * d;
        const y = (r3 * i + r4 * j + r5) * d;
        const dx = m0 * x + m4 * y - m8 * d;
        const dy = m1 * x + m5 * y - m9 * d;
        const dz = m2 * x + m6 * y - m10 * d;
        const vx = Math.floor((ox + dx) / edgeM);
        const vy = Math.floor((oy + dy) / edgeM);
        const vz = Math.floor((oz + dz) / edgeM);
        const chunk = chunks.make(vx, vy, vz);
        if (!chunk) continue;
        const index = indexIn(vx, vy, vz);
        const isFirst = chunk.hits[index] !== frameIndex;
        if (chunk.surface) {
          addPoint(chunk.surface, index, ox + dx, oy + dy, oz + dz, frame, i, j);
          const { rates } = chunk.surface;
          rates[index] = (rates[index] ?? 0) * (isFirst ? 1 - slow : 1) + slow;
        }
        if (!isFirst) continue;
        chunk.hits[index] = frameIndex;
        touched++;
        setWeight(chunk, index, (chunk.weights[index] ?? 0) * (1 - rate) + rate);
        const share = rate / Math.hypot(dx, dy, dz);
        const { seen } = chunk;
        const o = 3 * index;
        seen[o] = (seen[o] ?? 0) * (1 - rate) - share * dx;
        seen[o + 1] = (seen[o + 1] ?? 0) * (1 - rate) - share * dy;
        seen[o + 2] = (seen[o + 2] ?? 0) * (1 - rate) - share * dz;
      }
    }
  }
  function addPoint(
    { points, normals, counts }: NonNullable<Chunk['surface']>,
    index: number,
    px: number,
    py: number,
    pz: number,
    frame: DepthFrame,
    i: number,
    j: number,
  ): void {
    const count = Math.min((counts[index] ?? 0) + 1, MEAN_HITS);
    counts[index] = count;
    const share = 1 / count;
    writeNormal(frame, i, j, edgeM, scratchNormal);
    const o = 3 * index;
    points[o] = (points[o] ?? 0) + share * (px - (points[o] ?? 0));
    points[o + 1] = (points[o + 1] ?? 0) + share * (py - (points[o + 1] ?? 0));
    points[o + 2] = (points[o + 2] ?? 0) + share * (pz - (points[o + 2] ?? 0));
    for (let k = 0; k < 3; k++) normals[o + k] = (normals[o + k] ?? 0) + share * ((scratchNormal[k] ?? 0) - (normals[o + k] ?? 0));
  }
  /**
   * Whether a ray through a voxel, whose center is seen at a texel (i, j), ends more than an edge behind where it enters. Of a near voxel,
   * only some of the rays are tested.
   */
  function isPassed(frame: DepthFrame, px: number, py: number, pz: number, d: number, i: number, j: number): boolean {
    const { meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r } = frame;
    const half = 0.5 * edgeM;
    const least = d - MOST_REACH * edgeM + edgeM;
    const reach = (MOST_REACH * edgeM) / (Math.max(d - half, half) * Math.sqrt(Math.abs(at(r, 0) * at(r, 4) - at(r, 1) * at(r, 3))));
    const u0 = Math.max(Math.ceil(i - reach), 0);
    const u1 = Math.min(Math.floor(i + reach), widthPx - 1);
    const v0 = Math.max(Math.ceil(j - reach), 0);
    const v1 = Math.min(Math.floor(j + reach), heightPx - 1);
    const stride = Math.max(1, Math.ceil((2 * reach) / MAX_RAYS));
    for (let v = v0; v <= v1; v += stride) {
      for (let u = u0; u <= u1; u += stride) {
        const measured = meters[v * widthPx + u] ?? 0;
        if (!(measured > least && measured < farM)) continue;
        const x = at(r, 0) * u + at(r, 1) * v + at(r, 2);
        const y = at(r, 3) * u + at(r, 4) * v + at(r, 5);
        const dx = 1 / (at(m, 0) * x + at(m, 4) * y - at(m, 8));
        const dy = 1 / (at(m, 1) * x + at(m, 5) * y - at(m, 9));
        const dz = 1 / (at(m, 2) * x + at(m, 6) * y - at(m, 10));
        const hx = Math.abs(half * dx);
        const hy = Math.abs(half * dy);
        const hz = Math.abs(half * dz);
        const enter = Math.max(px * dx - hx, py * dy - hy, pz * dz - hz);
        const leave = Math.min(px * dx + hx, py * dy + hy, pz * dz + hz, measured - edgeM);
        if (enter > 0 && enter < leave) return true;
      }
    }
    return false;
  }
  /** Lowers the weight of voxels that were not hit and behind which depth measures a surface more than an edge away. */
  function decay(frame: DepthFrame, rate: number, slow: number): void {
    const { worldFromDepth: m, rayFromTexel: r } = frame;
    const determinant = at(r, 0) * at(r, 4) - at(r, 1) * at(r, 3);
    const half = (SIDE * edgeM) / 2;
    const radius = half * Math.sqrt(3);
    lowestM = Number.POSITIVE_INFINITY;
    for (const chunk of chunks.all()) {
      const cx = chunk.x * SIDE * edgeM + half - at(m, 12);
      const cy = chunk.y * SIDE * edgeM + half - at(m, 13);
      const cz = chunk.z * SIDE * edgeM + half - at(m, 14);
      const ahead = -(at(m, 8) * cx + at(m, 9) * cy + at(m, 10) * cz);
      let most = threshold;
      if (ahead >= -radius && ahead <= farM + radius) {
        most = 0;
        for (let index = 0; index < VOXELS; index++) {
          const weight = chunk.weights[index] ?? 0;
          if (weight === 0) continue;
          most = Math.max(most, weight);
          if (chunk.hits[index] === frameIndex) continue;
          const px = cx + ((index & 7) - 3.5) * edgeM;
          const py = cy + (((index >> 3) & 7) - 3.5) * edgeM;
          const pz = cz + ((index >> 6) - 3.5) * edgeM;
          const d = -(at(m, 8) * px + at(m, 9) * py + at(m, 10) * pz);
          if (d <= 0) continue;
          const rx = (at(m, 0) * px + at(m, 1) * py + at(m, 2) * pz) / d - at(r, 2);
          const ry = (at(m, 4) * px + at(m, 5) * py + at(m, 6) * pz) / d - at(r, 5);
          const i = (at(r, 4) * rx - at(r, 1) * ry) / determinant;
          const j = (at(r, 0) * ry - at(r, 3) * rx) / determinant;
          touched++;
          if (!isPassed(frame, px, py, pz, d, i, j)) continue;
          const left = weight * (1 - rate);
          setWeight(chunk, index, left < GONE ? 0 : left);
          if (!chunk.surface) continue;
          const { rates, counts } = chunk.surface;
          rates[index] = (rates[index] ?? 0) * (1 - slow);
          if (left < GONE) rates[index] = counts[index] = 0;
        }
      }
      if (most === 0) chunks.remove(chunk);
      else if (most >= threshold) lowestM = Math.min(lowestM, chunk.y * SIDE * edgeM);
    }
  }

  return {
    settings,
    surface,
    update: (frame) => {
      frameIndex++;
      touched = 0;
      changed.clear();
      if (!isFrame(frame)) return;
      const rate = 1 - (1 - speed) ** Math.min(30 * Math.max(frame.deltaS, 1 / 240), 30);
      const slow = 1 - Math.exp(-Math.max(frame.deltaS, 1 / 240) / SLOW_S);
      addHits(frame, rate, slow);
      decay(frame, rate, slow);
      surface?.invalidate();
    },
    save: () => saveVoxels(chunks, edgeM, threshold),
    load: (voxels, worldFromFile) => {
      chunks.clear();
      changed.clear();
      loadVoxels(chunks, edgeM, voxels, worldFromFile);
      lowestM = Number.POSITIVE_INFINITY;
      for (const chunk of chunks.all()) lowestM = Math.min(lowestM, chunk.y * SIDE * edgeM);
      surface?.invalidate();
    },
    isOccupied: (x, y, z) => weightAt(x, y, z) >= threshold,
    weightAt,
    isOutward: (x, y, z, dx, dy, dz) => {
      const chunk = chunks.of(x, y, z);
      if (!chunk) return true;
      const o = 3 * indexIn(x, y, z);
      return (chunk.seen[o] ?? 0) * dx + (chunk.seen[o + 1] ?? 0) * dy + (chunk.seen[o + 2] ?? 0) * dz > -0.1;
    },
    hasChanged: (minX, minY, minZ, maxX, maxY, maxZ) => {
      if (changed.size === 0) return false;
      for (let x = Math.floor(minX / edgeM); x <= Math.floor(maxX / edgeM); x++)
        for (let y = Math.floor(minY / edgeM); y <= Math.floor(maxY / edgeM); y++)
          for (let z = Math.floor(minZ / edgeM); z <= Math.floor(maxZ / edgeM); z++) if (changed.has(keyOf(x, y, z))) return true;
      return false;
    },
    forEachOccupied: (call) => {
      for (const { x, y, z, weights } of chunks.all()) {
        for (let i = 0; i < VOXELS; i++)
          if ((weights[i] ?? 0) >= threshold) call(x * SIDE + (i & 7), y * SIDE + ((i >> 3) & 7), z * SIDE + (i >> 6));
      }
    },
    get touched() {
      return touched;
    },
    get chunkCount() {
      return chunks.count;
    },
    get lowestM() {
      return lowestM;
    },
  };
}

function at(list: ArrayLike<number>, index: number): number {
  return list[index] ?? 0;
}

function isFrame({ worldFromDepth, rayFromTexel, deltaS }: DepthFrame): boolean {
  for (let i = 0; i < 16; i++) if (!Number.isFinite(worldFromDepth[i])) return false;
  for (let i = 0; i < 6; i++) if (!Number.isFinite(rayFromTexel[i])) return false;
  return Number.isFinite(deltaS);
}
