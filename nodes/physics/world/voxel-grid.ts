import type { DepthFrame, VoxelSettings } from '../../kit/physics.ts';

/** Voxels along each side of a chunk. */
const SIDE = 8;
const VOXELS = SIDE ** 3;
/** Lighter voxels are as good as never seen. */
const GONE = 0.01;
/** Chunks at most, so that noise cannot fill the memory: 40 MB. */
const MAX_CHUNKS = 8000;

interface Chunk {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly weights: Float32Array;
  /** Depth frame of the last hit. */
  readonly hits: Int32Array;
  /** Sum of directions to the cameras that saw each voxel: which side is outside. */
  readonly seen: Float32Array;
}

/**
 * A probabilistic voxel grid of what depth shows: V' = V · (1 − U) + U · H, once per voxel and depth frame. Chunks exist where something was
 * seen, so memory follows surfaces. A voxel outside the view, or behind what is measured, keeps its weight.
 */
export interface VoxelGrid {
  readonly settings: VoxelSettings;
  update(frame: DepthFrame): void;
  isOccupied(x: number, y: number, z: number): boolean;
  weightAt(x: number, y: number, z: number): number;
  /** Whether a direction leaves the voxel towards a side from which it was seen. */
  isOutward(x: number, y: number, z: number, dx: number, dy: number, dz: number): boolean;
  /** Whether a voxel in the box became occupied or free in the last update. World space. */
  hasChanged(minX: number, minY: number, minZ: number, maxX: number, maxY: number, maxZ: number): boolean;
  /** Calls back with the indices of all occupied voxels. */
  forEachOccupied(call: (x: number, y: number, z: number) => void): void;
  /** Voxels that the last update has read or written. */
  readonly touched: number;
}

export function createVoxelGrid(settings: VoxelSettings): VoxelGrid {
  const { edgeM, threshold, speed, farM } = settings;
  const chunks = new Map<number, Chunk>();
  const changed = new Set<number>();
  let frameIndex = 0;
  let touched = 0;
  // The chunk that was found last: neighbors ask for the same one.
  let lastKey = Number.NaN;
  let lastChunk: Chunk | undefined;

  function chunkAt(cx: number, cy: number, cz: number): Chunk | undefined {
    const key = keyOf(cx, cy, cz);
    if (key === lastKey) return lastChunk;
    lastKey = key;
    lastChunk = chunks.get(key);
    return lastChunk;
  }
  function makeChunk(x: number, y: number, z: number): Chunk | undefined {
    const found = chunkAt(x, y, z);
    if (found || chunks.size >= MAX_CHUNKS) return found;
    const made = { x, y, z, weights: new Float32Array(VOXELS), hits: new Int32Array(VOXELS), seen: new Float32Array(3 * VOXELS) };
    chunks.set(keyOf(x, y, z), made);
    lastChunk = made;
    return made;
  }
  function setWeight(chunk: Chunk, index: number, weight: number): void {
    const before = chunk.weights[index] ?? 0;
    chunk.weights[index] = weight;
    if (before >= threshold !== weight >= threshold) changed.add(keyOf(chunk.x, chunk.y, chunk.z));
  }
  function weightAt(x: number, y: number, z: number): number {
    return chunkAt(x >> 3, y >> 3, z >> 3)?.weights[indexIn(x, y, z)] ?? 0;
  }

  function addHits(frame: DepthFrame, rate: number): void {
    const { meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r } = frame;
    const [r0, r1, r2, r3, r4, r5] = [at(r, 0), at(r, 1), at(r, 2), at(r, 3), at(r, 4), at(r, 5)];
    const [ox, oy, oz] = [at(m, 12), at(m, 13), at(m, 14)];
    for (let j = 0; j < heightPx; j++) {
      for (let i = 0; i < widthPx; i++) {
        const d = meters[j * widthPx + i] ?? 0;
        if (!(d > 0 && d < farM)) continue;
        const x = (r0 * i + r1 * j + r2) * d;
        const y = (r3 * i + r4 * j + r5) * d;
        const dx = at(m, 0) * x + at(m, 4) * y - at(m, 8) * d;
        const dy = at(m, 1) * x + at(m, 5) * y - at(m, 9) * d;
        const dz = at(m, 2) * x + at(m, 6) * y - at(m, 10) * d;
        const vx = Math.floor((ox + dx) / edgeM);
        const vy = Math.floor((oy + dy) / edgeM);
        const vz = Math.floor((oz + dz) / edgeM);
        const chunk = makeChunk(vx >> 3, vy >> 3, vz >> 3);
        if (!chunk) continue;
        const index = indexIn(vx, vy, vz);
        if (chunk.hits[index] === frameIndex) continue;
        chunk.hits[index] = frameIndex;
        touched++;
        const before = chunk.weights[index] ?? 0;
        setWeight(chunk, index, before * (1 - rate) + rate);
        const length = Math.hypot(dx, dy, dz);
        for (const [k, c] of [dx, dy, dz].entries())
          chunk.seen[3 * index + k] = (chunk.seen[3 * index + k] ?? 0) * (1 - rate) - (rate * c) / length;
      }
    }
  }
  /** Voxels that were not hit and that depth passes by more than an edge are free. */
  function decay(frame: DepthFrame, rate: number): void {
    const { meters, widthPx, heightPx, worldFromDepth: m, rayFromTexel: r } = frame;
    const determinant = at(r, 0) * at(r, 4) - at(r, 1) * at(r, 3);
    const half = (SIDE * edgeM) / 2;
    const radius = half * Math.sqrt(3);
    for (const [key, chunk] of chunks) {
      const cx = chunk.x * SIDE * edgeM + half - at(m, 12);
      const cy = chunk.y * SIDE * edgeM + half - at(m, 13);
      const cz = chunk.z * SIDE * edgeM + half - at(m, 14);
      const ahead = -(at(m, 8) * cx + at(m, 9) * cy + at(m, 10) * cz);
      if (ahead < -radius || ahead > farM + radius) continue;
      let most = 0;
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
        // A ray through any part of the voxel frees it: its middle and a ring around it are looked up.
        const reach = (0.35 * edgeM) / (d * Math.sqrt(Math.abs(determinant)));
        let isFree = false;
        for (let k = 0; k < 5 && !isFree; k++) {
          const u = Math.round(i + (k === 1 ? reach : k === 2 ? -reach : 0));
          const v = Math.round(j + (k === 3 ? reach : k === 4 ? -reach : 0));
          if (u < 0 || v < 0 || u >= widthPx || v >= heightPx) continue;
          const measured = meters[v * widthPx + u] ?? 0;
          isFree = measured > 0 && measured < farM && measured - d > edgeM;
        }
        if (!isFree) continue;
        const left = weight * (1 - rate);
        setWeight(chunk, index, left < GONE ? 0 : left);
      }
      if (most === 0) {
        chunks.delete(key);
        lastKey = Number.NaN;
      }
    }
  }

  return {
    settings,
    update: (frame) => {
      frameIndex++;
      touched = 0;
      changed.clear();
      if (!isFrame(frame)) return;
      const rate = 1 - (1 - speed) ** Math.min(30 * Math.max(frame.deltaS, 1 / 240), 30);
      addHits(frame, rate);
      decay(frame, rate);
    },
    isOccupied: (x, y, z) => weightAt(x, y, z) >= threshold,
    weightAt,
    isOutward: (x, y, z, dx, dy, dz) => {
      const chunk = chunkAt(x >> 3, y >> 3, z >> 3);
      if (!chunk) return true;
      const o = 3 * indexIn(x, y, z);
      return (chunk.seen[o] ?? 0) * dx + (chunk.seen[o + 1] ?? 0) * dy + (chunk.seen[o + 2] ?? 0) * dz > -0.1;
    },
    hasChanged: (minX, minY, minZ, maxX, maxY, maxZ) => {
      if (changed.size === 0) return false;
      const size = SIDE * edgeM;
      for (let x = Math.floor(minX / size); x <= Math.floor(maxX / size); x++)
        for (let y = Math.floor(minY / size); y <= Math.floor(maxY / size); y++)
          for (let z = Math.floor(minZ / size); z <= Math.floor(maxZ / size); z++) if (changed.has(keyOf(x, y, z))) return true;
      return false;
    },
    forEachOccupied: (call) => {
      for (const { x, y, z, weights } of chunks.values()) {
        for (let i = 0; i < VOXELS; i++)
          if ((weights[i] ?? 0) >= threshold) call(x * SIDE + (i & 7), y * SIDE + ((i >> 3) & 7), z * SIDE + (i >> 6));
      }
    },
    get touched() {
      return touched;
    },
  };
}

/** Chunks of ±2¹⁶ along each axis: 26 km at 5 cm. */
function keyOf(x: number, y: number, z: number): number {
  return (x + 65536) * 2 ** 34 + (y + 65536) * 2 ** 17 + (z + 65536);
}

function indexIn(x: number, y: number, z: number): number {
  return (x & 7) | ((y & 7) << 3) | ((z & 7) << 6);
}

function at(list: ArrayLike<number>, index: number): number {
  return list[index] ?? 0;
}

function isFrame({ worldFromDepth, rayFromTexel, deltaS }: DepthFrame): boolean {
  for (let i = 0; i < 16; i++) if (!Number.isFinite(worldFromDepth[i])) return false;
  for (let i = 0; i < 6; i++) if (!Number.isFinite(rayFromTexel[i])) return false;
  return Number.isFinite(deltaS);
}
