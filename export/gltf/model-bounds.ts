import type { Gltf, GltfAccessor, GltfDocument, GltfNode } from './document.ts';
import { readNumbers } from './read-numbers.ts';

/** A box around a model in its own space. */
export interface ModelBounds {
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}

/** Column-major 4×4. */
type Matrix = Float32Array;

const IDENTITY: Matrix = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
/** Divisors of normalized integers, by component type (glTF 2.0, §3.11). */
const LARGEST: Readonly<Record<number, number>> = { 5120: 127, 5121: 255, 5122: 32_767, 5123: 65_535 };

/**
 * Returns a box around the meshes of the shown scene, from the limits of their positions (glTF 2.0, §3.6.2.5) and without decoding them.
 * Morph targets and animations do not count, and a skinned mesh stands as its first joint does. Null without meshes that have limits.
 */
export function modelBounds(gltf: Gltf): ModelBounds | null {
  const { document } = gltf;
  const { nodes = [], meshes = [], accessors = [], scenes = [] } = document;
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  const worlds = worldMatrices(document);
  for (const [index, world] of worlds) {
    const node = nodes[index];
    const placed = node && node.mesh !== undefined ? (skinMatrix(gltf, node, worlds) ?? world) : world;
    for (const { attributes } of meshes[node?.mesh ?? -1]?.primitives ?? []) {
      for (const corner of cornersOf(accessors[attributes.POSITION ?? -1])) {
        for (const axis of [0, 1, 2] as const) {
          const value = row(placed, axis, corner);
          min[axis] = Math.min(min[axis], value);
          max[axis] = Math.max(max[axis], value);
        }
      }
    }
  }
  return scenes.length > 0 && [...min, ...max].every(Number.isFinite) ? { min, max } : null;
}

/** The world matrices of the nodes of the shown scene, by index. */
function worldMatrices({ scene = 0, scenes = [], nodes = [] }: GltfDocument): ReadonlyMap<number, Matrix> {
  const worlds = new Map<number, Matrix>();
  const visit = (index: number, parent: Matrix) => {
    const node = nodes[index];
    // A node has one parent, but a broken file may list it again, even below itself.
    if (!node || worlds.has(index)) return;
    const world = product(parent, localMatrix(node));
    worlds.set(index, world);
    for (const child of node.children ?? []) visit(child, world);
  };
  for (const root of scenes[scene]?.nodes ?? []) visit(root, IDENTITY);
  return worlds;
}

/** The place of a skinned mesh, which its node has no influence on; null for other meshes. In the pose of binding, all joints agree on it. */
function skinMatrix(gltf: Gltf, { skin }: GltfNode, worlds: ReadonlyMap<number, Matrix>): Matrix | null {
  const { inverseBindMatrices, joints = [] } = gltf.document.skins?.[skin ?? -1] ?? {};
  const joint = worlds.get(joints[0] ?? -1);
  if (!joint) return null;
  const accessor = gltf.document.accessors?.[inverseBindMatrices ?? -1];
  if (accessor === undefined) return joint;
  const inverse = readNumbers(gltf, inverseBindMatrices);
  return inverse && product(joint, new Float32Array(inverse.subarray(0, 16)));
}

function cornersOf(accessor: GltfAccessor | undefined): readonly (readonly [number, number, number])[] {
  const { min, max, normalized = false, componentType = 0 } = accessor ?? {};
  if (min?.length !== 3 || max?.length !== 3) return [];
  const per = normalized ? (LARGEST[componentType] ?? 1) : 1;
  const ends = [min.map((value) => value / per), max.map((value) => value / per)] as const;
  const at = (bit: number, axis: number) => ends[bit === 0 ? 0 : 1][axis] ?? 0;
  return Array.from({ length: 8 }, (_, corner) => [at(corner & 1, 0), at(corner & 2, 1), at(corner & 4, 2)] as const);
}

function localMatrix({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: GltfNode): Matrix {
  if (matrix?.length === 16) return new Float32Array(matrix);
  const [x = 0, y = 0, z = 0, w = 1] = rotation;
  const [sx = 1, sy = 1, sz = 1] = scale;
  const [tx = 0, ty = 0, tz = 0] = translation;
  return new Float32Array([
    ...[(1 - 2 * (y * y + z * z)) * sx, 2 * (x * y + z * w) * sx, 2 * (x * z - y * w) * sx, 0],
    ...[2 * (x * y - z * w) * sy, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z + x * w) * sy, 0],
    ...[2 * (x * z + y * w) * sz, 2 * (y * z - x * w) * sz, (1 - 2 * (x * x + y * y)) * sz, 0],
    ...[tx, ty, tz, 1],
  ]);
}

function row(matrix: Matrix, axis: number, [x, y, z]: readonly [number, number, number]): number {
  const at = (column: number) => matrix[4 * column + axis] ?? 0;
  return at(0) * x + at(1) * y + at(2) * z + at(3);
}

function product(a: Float32Array, b: Float32Array): Float32Array {
  return Float32Array.from({ length: 16 }, (_, i) => {
    const [column, line] = [i >> 2, i & 3];
    let sum = 0;
    for (let k = 0; k < 4; k++) sum += (a[4 * k + line] ?? 0) * (b[4 * column + k] ?? 0);
    return sum;
  });
}
