import type { CaptureMesh } from '../../nodes/kit/capture.ts';
import type { GltfDocument } from '../gltf/document.ts';
import { packGlb } from '../gltf/pack-glb.ts';

/** Faces that meet at a larger angle have an edge between them: the usual one of modelers. */
const CREASE_COS = Math.cos((40 * Math.PI) / 180);

/** Joins vertices at the same place, which models have along the borders of textures, so that a simplification opens no gaps there. */
export function weldMesh({ positions, indices }: CaptureMesh): CaptureMesh {
  const firstAt = new Map<string, number>();
  const kept: number[] = [];
  const welded = Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => {
    const place = positions.subarray(3 * vertex, 3 * vertex + 3);
    const key = place.join();
    const found = firstAt.get(key) ?? kept.length / 3;
    if (found === kept.length / 3) {
      firstAt.set(key, found);
      kept.push(...place);
    }
    return found;
  });
  return { positions: Float32Array.from(kept), indices: indices.map((vertex) => welded[vertex] ?? 0) };
}

/** A mesh as a GLB file with one gray material. Faces that meet at less than 40° are shaded smoothly. */
export function meshAsGlb(mesh: CaptureMesh): Uint8Array<ArrayBuffer> {
  const { positions, normals, indices } = shaded(mesh);
  const [min, max] = [Math.min, Math.max].map((pick) =>
    [0, 1, 2].map((axis) => positions.reduce((best, value, i) => (i % 3 === axis ? pick(best, value) : best), positions[axis] ?? 0)),
  );
  const parts = [positions, normals, indices];
  const binary = new Uint8Array(parts.reduce((sum, { byteLength }) => sum + byteLength, 0));
  let at = 0;
  const bufferViews = parts.map(({ buffer, byteLength }) => {
    binary.set(new Uint8Array(buffer), at);
    at += byteLength;
    return { buffer: 0, byteOffset: at - byteLength, byteLength };
  });
  const count = positions.length / 3;
  // glTF 2.0: 5126 is a 32-bit float, 5125 a 32-bit index.
  const document = {
    asset: { version: '2.0', generator: 'Scrim' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.6, 0.6, 0.6, 1], metallicFactor: 0, roughnessFactor: 0.8 } }],
    accessors: [
      { bufferView: 0, componentType: 5126, count, type: 'VEC3', min, max },
      { bufferView: 1, componentType: 5126, count, type: 'VEC3' },
      { bufferView: 2, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews,
    buffers: [{ byteLength: binary.length }],
  };
  return packGlb({ document: document as GltfDocument, binary }, new Map());
}

/** The corners of triangles with normals: the mean of those faces around a vertex that meet without a crease. */
function shaded({ positions, indices }: CaptureMesh) {
  const faces = faceNormals(positions, indices);
  const around = Array.from({ length: positions.length / 3 }, (): number[] => []);
  for (let i = 0; i < indices.length; i++) around[indices[i] ?? 0]?.push(Math.floor(i / 3));
  const corners = new Map<string, number>();
  const [places, normals]: [number[], number[]] = [[], []];
  const out = Uint32Array.from(indices, (vertex, i) => {
    const face = faces.subarray(3 * Math.floor(i / 3), 3 * Math.floor(i / 3) + 3);
    const sum = [0, 0, 0];
    for (const other of around[vertex] ?? []) {
      const normal = faces.subarray(3 * other, 3 * other + 3);
      if (dot(face, normal) < CREASE_COS * Math.hypot(...face) * Math.hypot(...normal)) continue;
      for (const axis of [0, 1, 2]) sum[axis] = (sum[axis] ?? 0) + (normal[axis] ?? 0);
    }
    const length = Math.hypot(...sum);
    const normal = length > 0 ? sum.map((value) => value / length) : [0, 1, 0];
    const key = `${vertex} ${normal.map((value) => value.toFixed(3)).join()}`;
    const found = corners.get(key) ?? places.length / 3;
    if (found === places.length / 3) {
      corners.set(key, found);
      places.push(...positions.subarray(3 * vertex, 3 * vertex + 3));
      normals.push(...normal);
    }
    return found;
  });
  return { positions: Float32Array.from(places), normals: Float32Array.from(normals), indices: out };
}

/** Normals of triangles, as long as twice their areas. */
function faceNormals(positions: Float32Array, indices: Uint32Array): Float32Array {
  const normals = new Float32Array(indices.length);
  const at = (corner: number, axis: number): number => positions[3 * (indices[corner] ?? 0) + (axis % 3)] ?? 0;
  for (let face = 0; face < indices.length; face += 3) {
    const edge = (corner: number, axis: number): number => at(face + corner, axis) - at(face, axis);
    for (const axis of [0, 1, 2]) {
      normals[face + axis] = edge(1, axis + 1) * edge(2, axis + 2) - edge(1, axis + 2) * edge(2, axis + 1);
    }
  }
  return normals;
}

function dot(a: Float32Array, b: Float32Array): number {
  return a.reduce((sum, value, axis) => sum + value * (b[axis] ?? 0), 0);
}
