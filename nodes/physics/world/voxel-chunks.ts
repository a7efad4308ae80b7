/** Voxels along each side of a chunk. */
export const SIDE = 8;
export const VOXELS = SIDE ** 3;
/** The most chunks, so that noise cannot fill the memory: 40 MB, with a smooth surface 100 MB. */
const MAX_CHUNKS = 8000;

/** A cube of `SIDE` voxels along each side; `indexIn` gives the index of a voxel in its arrays. */
export interface Chunk {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly weights: Float32Array;
  /** For each voxel, the number of the depth frame that last hit it. */
  readonly hits: Int32Array;
  /** For each voxel, the sum of the directions to the cameras that saw it, which tells the outer side. */
  readonly seen: Float32Array;
  readonly surface: ChunkSurface | null;
}

/** The data of each voxel from which the smooth surface is computed. */
export interface ChunkSurface {
  /** For each voxel, the mean of the points that hit it, world space; `normals` has the mean of the normals there, not normalized. */
  readonly points: Float32Array;
  readonly normals: Float32Array;
  /** For each voxel, how many hits both means contain; older hits lose weight. */
  readonly counts: Uint8Array;
  /** For each voxel, the mean number of points per depth frame, over some seconds. */
  readonly rates: Float32Array;
  /**
   * For each voxel, the signed distance of its center from the surface, NaN where unknown. `fieldFrames` has the depth frame in which it
   * was computed.
   */
  readonly field: Float32Array;
  readonly fieldFrames: Int32Array;
  /**
   * For each voxel, the vertex of the surface between it and its seven next ones, NaN for none. `vertexFrames` has the depth frame in which
   * it was computed.
   */
  readonly vertices: Float32Array;
  readonly vertexFrames: Int32Array;
}

/** The chunks of a grid by their position. A chunk exists only where something was seen, so memory grows with the area of surfaces. */
export interface VoxelChunks {
  readonly count: number;
  /** The chunk that contains a voxel. */
  of(vx: number, vy: number, vz: number): Chunk | undefined;
  /** The chunk that contains a voxel; it is created if it is missing. Undefined if there are too many chunks. */
  make(vx: number, vy: number, vz: number): Chunk | undefined;
  remove(chunk: Chunk): void;
  clear(): void;
  all(): Iterable<Chunk>;
}

export function createVoxelChunks(hasSurface: boolean): VoxelChunks {
  const chunks = new Map<number, Chunk>();
  // The chunk that was found last: neighbors ask for the same one.
  let lastKey = Number.NaN;
  let lastChunk: Chunk | undefined;

  function of(vx: number, vy: number, vz: number): Chunk | undefined {
    const key = keyOf(vx >> 3, vy >> 3, vz >> 3);
    if (key === lastKey) return lastChunk;
    lastKey = key;
    lastChunk = chunks.get(key);
    return lastChunk;
  }
  return {
    get count() {
      return chunks.size;
    },
    of,
    make: (vx, vy, vz) => {
      const found = of(vx, vy, vz);
      if (found || chunks.size >= MAX_CHUNKS) return found;
      const made: Chunk = {
        x: vx >> 3,
        y: vy >> 3,
        z: vz >> 3,
        weights: new Float32Array(VOXELS),
        hits: new Int32Array(VOXELS),
        seen: new Float32Array(3 * VOXELS),
        surface: hasSurface ? createSurface() : null,
      };
      chunks.set(lastKey, made);
      lastChunk = made;
      return made;
    },
    remove: ({ x, y, z }) => {
      chunks.delete(keyOf(x, y, z));
      lastKey = Number.NaN;
    },
    clear: () => {
      chunks.clear();
      lastKey = Number.NaN;
    },
    all: () => chunks.values(),
  };
}

function createSurface(): ChunkSurface {
  return {
    points: new Float32Array(3 * VOXELS),
    normals: new Float32Array(3 * VOXELS),
    counts: new Uint8Array(VOXELS),
    rates: new Float32Array(VOXELS),
    field: new Float32Array(VOXELS),
    fieldFrames: new Int32Array(VOXELS),
    vertices: new Float32Array(3 * VOXELS),
    vertexFrames: new Int32Array(VOXELS),
  };
}

/** The key of a chunk or voxel by its indices, ±2¹⁶ along each axis: voxels of 5 cm repeat after 6 km. */
export function keyOf(x: number, y: number, z: number): number {
  return (x + 65536) * 2 ** 34 + (y + 65536) * 2 ** 17 + (z + 65536);
}

export function indexIn(vx: number, vy: number, vz: number): number {
  return (vx & 7) | ((vy & 7) << 3) | ((vz & 7) << 6);
}
