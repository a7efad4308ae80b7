import { CaptureError, type CaptureMesh } from '../../nodes/kit/capture.ts';
import type { Gltf, GltfNode } from '../gltf/document.ts';
import { readNumbers } from '../gltf/read-numbers.ts';
import { createMeshBuilder, type MeshBuilder } from './mesh-builder.ts';

/** A transform as the first three rows of its matrix. */
type Affine = readonly number[];

const IDENTITY: Affine = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/** Reads the triangles of a glTF model without its animation. @throws CaptureError for compressed models */
export function readGltfMesh(gltf: Gltf): CaptureMesh {
  const builder = createMeshBuilder();
  const offset = { vertices: 0 };
  const visit = (index: number, parent: Affine): void => {
    const node = gltf.document.nodes?.[index];
    if (!node) return;
    const transform = multiply(parent, transformOf(node));
    if (node.mesh !== undefined) addMesh(gltf, node.mesh, transform, builder, offset);
    for (const child of node.children ?? []) visit(child, transform);
  };
  for (const { nodes = [] } of gltf.document.scenes?.slice(0, 1) ?? []) for (const node of nodes) visit(node, IDENTITY);
  return builder.build();
}

function addMesh(gltf: Gltf, mesh: number, m: Affine, builder: MeshBuilder, offset: { vertices: number }): void {
  for (const { attributes, indices, mode = 4 } of gltf.document.meshes?.[mesh]?.primitives ?? []) {
    if (mode !== 4) continue;
    const positions = readNumbers(gltf, attributes.POSITION);
    const corners = indices === undefined ? null : readNumbers(gltf, indices);
    if (!positions || (indices !== undefined && !corners)) {
      throw new CaptureError('the mesh is a compressed glTF model. Export it without compression');
    }
    const count = positions.length / 3;
    const row = (r: number, i: number): number =>
      [0, 1, 2].reduce((sum, c) => sum + (m[4 * r + c] ?? 0) * (positions[3 * i + c] ?? 0), m[4 * r + 3] ?? 0);
    for (let i = 0; i < count; i++) builder.vertex(row(0, i), row(1, i), row(2, i));
    const corner = (i: number): number => offset.vertices + (corners ? (corners[i] ?? 0) : i);
    for (let i = 0; i + 2 < (corners?.length ?? count); i += 3) builder.polygon([corner(i), corner(i + 1), corner(i + 2)]);
    offset.vertices += count;
  }
}

function transformOf({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }: GltfNode): Affine {
  if (matrix) return IDENTITY.map((_, i) => matrix[4 * (i % 4) + Math.floor(i / 4)] ?? 0);
  const [x = 0, y = 0, z = 0, w = 1] = rotation;
  const [sx = 1, sy = 1, sz = 1] = scale;
  const [tx = 0, ty = 0, tz = 0] = translation;
  return [
    ...[(1 - 2 * (y * y + z * z)) * sx, 2 * (x * y - w * z) * sy, 2 * (x * z + w * y) * sz, tx],
    ...[2 * (x * y + w * z) * sx, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z - w * x) * sz, ty],
    ...[2 * (x * z - w * y) * sx, 2 * (y * z + w * x) * sy, (1 - 2 * (x * x + y * y)) * sz, tz],
  ];
}

function multiply(a: Affine, b: Affine): Affine {
  return IDENTITY.map((_, i) => {
    const [r, c] = [Math.floor(i / 4), i % 4];
    return [0, 1, 2].reduce((sum, k) => sum + (a[4 * r + k] ?? 0) * (b[4 * k + c] ?? 0), c === 3 ? (a[4 * r + 3] ?? 0) : 0);
  });
}
