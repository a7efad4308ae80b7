/** Occupied voxels of a measured room. The index of a voxel is its position divided by the edge, rounded down. */
export interface VoxelFile {
  readonly edgeM: number;
  readonly count: number;
  /** x, y and z of each voxel. */
  readonly indices: Int16Array;
  /** The weight of each voxel times 255. */
  readonly weights: Uint8Array;
  /** For each voxel, the mean of the directions to the cameras that saw it, times 127. */
  readonly seen: Int8Array;
  /** For each voxel, the mean of the measured points, from its lowest corner, as a part of the edge times 255. */
  readonly points: Uint8Array;
  /** For each voxel, the unit normal of the surface there times 127; zeros where none was measured. */
  readonly normals: Int8Array;
}

/** What reading a file gives: the voxels, or why there are none, as a sentence. */
export type ReadVoxels = { readonly voxels: VoxelFile; readonly problem: null } | { readonly voxels: null; readonly problem: string };

/** The first bytes of a file: “SCVX”. */
const MAGIC = 0x58564353;
const VERSION = 1;
/** Bytes before the first voxel, and of each voxel. */
export const FILE_HEADER_BYTES = 20;
export const FILE_VOXEL_BYTES = 16;
/** The most voxels of a file, 4 MB: ten rooms of 6 × 6 m with voxels of 5 cm. */
export const MAX_FILE_VOXELS = 250_000;

/**
 * Writes voxels as a file: magic number, version (16 bits), two bytes of zeros, edge in meters (32-bit float), number of voxels and
 * checksum of what follows (32 bits each), then 16 bytes per voxel: index (three times 16 bits), weight, direction, point, normal. All
 * numbers are little-endian.
 *
 * @throws RangeError for more than `MAX_FILE_VOXELS`.
 *
 * @example
 * room.file = writeVoxelFile(grid.save());
 */
export function writeVoxelFile({ edgeM, count, indices, weights, seen, points, normals }: VoxelFile): Uint8Array<ArrayBuffer> {
  if (count > MAX_FILE_VOXELS) throw new RangeError(`A voxel file has at most ${MAX_FILE_VOXELS} voxels.`);
  const bytes = new Uint8Array(FILE_HEADER_BYTES + FILE_VOXEL_BYTES * count);
  const view = new DataView(bytes.buffer);
  for (let i = 0; i < count; i++) {
    const o = FILE_HEADER_BYTES + FILE_VOXEL_BYTES * i;
    view.setUint8(o + 6, weights[i] ?? 0);
    for (let axis = 0; axis < 3; axis++) {
      const k = 3 * i + axis;
      view.setInt16(o + 2 * axis, indices[k] ?? 0, true);
      view.setInt8(o + 7 + axis, seen[k] ?? 0);
      view.setUint8(o + 10 + axis, points[k] ?? 0);
      view.setInt8(o + 13 + axis, normals[k] ?? 0);
    }
  }
  view.setUint32(0, MAGIC, true);
  view.setUint16(4, VERSION, true);
  view.setFloat32(8, edgeM, true);
  view.setUint32(12, count, true);
  view.setUint32(16, checksum(bytes), true);
  return bytes;
}

/**
 * Reads a voxel file. Never throws: a file that is not one, of another version, truncated or changed gives a problem.
 *
 * @example
 * const { voxels, problem } = readVoxelFile(bytes);
 */
export function readVoxelFile(bytes: Uint8Array): ReadVoxels {
  const no = (problem: string): ReadVoxels => ({ voxels: null, problem });
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 4 || view.getUint32(0, true) !== MAGIC) return no('It is not a voxel file.');
  if (bytes.length < FILE_HEADER_BYTES) return no('It is truncated.');
  const version = view.getUint16(4, true);
  if (version !== VERSION) return no(`It has version ${version}; this program reads version ${VERSION}.`);
  const edgeM = view.getFloat32(8, true);
  const count = view.getUint32(12, true);
  if (!(edgeM > 0 && edgeM < 10) || count > MAX_FILE_VOXELS) return no('Its header is damaged.');
  const needed = FILE_HEADER_BYTES + FILE_VOXEL_BYTES * count;
  if (bytes.length < needed) return no(`It is truncated: it has ${bytes.length} of ${needed} bytes.`);
  if (bytes.length > needed) return no('It has more bytes than its voxels need.');
  if (view.getUint32(16, true) !== checksum(bytes)) return no('It is damaged: its checksum differs.');
  const voxels = emptyVoxels(edgeM, count);
  for (let i = 0; i < count; i++) {
    const o = FILE_HEADER_BYTES + FILE_VOXEL_BYTES * i;
    voxels.weights[i] = view.getUint8(o + 6);
    for (let axis = 0; axis < 3; axis++) {
      const k = 3 * i + axis;
      voxels.indices[k] = view.getInt16(o + 2 * axis, true);
      voxels.seen[k] = view.getInt8(o + 7 + axis);
      voxels.points[k] = view.getUint8(o + 10 + axis);
      voxels.normals[k] = view.getInt8(o + 13 + axis);
    }
  }
  return { voxels, problem: null };
}

/**
 * Creates voxels whose numbers are all 0.
 *
 * @example
 * const voxels = emptyVoxels(0.05, grid.occupiedCount);
 */
export function emptyVoxels(edgeM: number, count: number): VoxelFile {
  return {
    edgeM,
    count,
    indices: new Int16Array(3 * count),
    weights: new Uint8Array(count),
    seen: new Int8Array(3 * count),
    points: new Uint8Array(3 * count),
    normals: new Int8Array(3 * count),
  };
}

/** FNV-1a of the voxels, 32 bits. */
function checksum(bytes: Uint8Array): number {
  let hash = 0x811c9dc5;
  for (let i = FILE_HEADER_BYTES; i < bytes.length; i++) hash = Math.imul(hash ^ (bytes[i] ?? 0), 0x01000193);
  return hash >>> 0;
}
