/** Voxels along each side of a chunk. */
export const SIDE = 8;
export const VOXELS = SIDE ** 3;
/** Chunks at most, so that noise cannot fill the memory: 40 MB, with a smooth surface 100 MB. */
const MAX_CHUNKS = 8000;

/** The voxels of a cube of `SIDE` voxels; the arrays are indexed by `indexIn`. */
export interface Chunk {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly weights: Float32Array;
  /** Depth frame of the last hit. */
  readonly hits: Int32Array;
  /** Sum of directions to the cameras that saw each voxel: which side is outside. */
  readonly seen: Float32Array;
  readonly surface: ChunkSurface | null;
}

/** What a smooth surface needs of each voxel. */
export interface ChunkSurface {
  /** Mean of the points that hit the voxel, world space, and of the normals there, not normalized. */
  readonly points: Float32Array;
  readonly normals: Float32Array;
  /** How many of the last hits both means contain. */
  readonly counts: Uint8Array;
  /** Signed distance from the surface at the middle of the voxel, NaN where unknown, and the depth frame that it was computed in. */
  readonly field: Float32Array;
  readonly fieldFrames: Int32Array;
  /** Vertex of the surface between this voxel and its seven next ones, NaN for none, and the depth frame that it was computed in. */
  readonly vertices: Float32Array;
  readonly vertexFrames: Int32Array;
}

/** Chunks by their place. They exist where something was seen, so memory follows surfaces. */
export interface VoxelChunks {
  readonly count: number;
  /** The chunk that contains a voxel. */
  of(vx: number, vy: number, vz: number): Chunk | undefined;
  /** The chunk that contains a voxel, which is made if it is missing; undefined if there are too many. */
  make(vx: number, vy: number, vz: number): Chunk | undefined;
  remove(chunk: Chunk): void;
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
        ...{ x: vx >> 3, y: vy >> 3, z: vz >> 3 },
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
    all: () => chunks.values(),
  };
}

function createSurface(): ChunkSurface {
  return {
    points: new Float32Array(3 * VOXELS),
    normals: new Float32Array(3 * VOXELS),
    counts: new Uint8Array(VOXELS),
    field: new Float32Array(VOXELS),
    fieldFrames: new Int32Array(VOXELS),
    vertices: new Float32Array(3 * VOXELS),
    vertexFrames: new Int32Array(VOXELS),
  };
}

/** Of a chunk or a voxel, ±2¹⁶ along each axis: voxels of 5 cm repeat after 6 km. */
export function keyOf(x: number, y: number, z: number): number {
  return (x + 65536) * 2 ** 34 + (y + 65536) * 2 ** 17 + (z + 65536);
}

export function indexIn(vx: number, vy: number, vz: number): number {
  return (vx & 7) | ((vy & 7) << 3) | ((vz & 7) << 6);
}
