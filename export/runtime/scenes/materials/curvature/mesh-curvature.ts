import { BufferAttribute, type Mesh, Vector3 } from 'three';
import { createMeshShape, type MeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { curvatureOf } from './curvature.ts';
import { isTooLarge } from './mesh-limit.ts';
import { tangentFrames } from './tangent-frames.ts';

const NAME = 'scrimCurvature';

/** At an edge with a larger angle between its faces, a mesh has a crease and no curvature; creases are lines already. */
const CREASE_RAD = 0.7;

/**
 * Adds the curvature of a mesh at rest to its geometry, once: `scrimCurvature` and `scrimCurvature2` with a principal direction and its
 * curvature each, and `scrimCurvatureChange` with the derivatives of curvature. Curvatures are in one per radius of the mesh, so that they
 * do not depend on its size. They are 0 in a mesh that is too large to compute them.
 */
export function ensureCurvature(master: Mesh): void {
  const { geometry } = master;
  const { position } = geometry.attributes;
  if (!position || geometry.attributes[NAME]) return;
  const names = [NAME, `${NAME}2`, `${NAME}Change`] as const;
  if (isTooLarge(geometry)) {
    // A surface that bends nowhere, in as few bytes as a buffer can have.
    const flat = new BufferAttribute(new Int8Array(position.count * 4), 4);
    for (const name of names) geometry.setAttribute(name, flat);
    return;
  }
  const shape = createMeshShape(geometry, () => true);
  const positions = restVertices(master, shape);
  const frames = tangentFrames(shape, positions);
  const { first, second, k1, k2, change } = curvatureOf(shape, positions, frames);
  const isCrease = findCreases(shape, positions);
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  const radius = geometry.boundingSphere?.radius || 1;
  const texels = [0, 1, 2].map(() => new Float32Array(position.count * 4)) as [Float32Array, Float32Array, Float32Array];
  for (let vertex = 0; vertex < position.count; vertex++) {
    const from = shape.weldedOf[vertex] ?? 0;
    texels[0].set([...first.subarray(from * 3, from * 3 + 3), (k1[from] ?? 0) * radius], vertex * 4);
    texels[1].set([...second.subarray(from * 3, from * 3 + 3), (k2[from] ?? 0) * radius], vertex * 4);
    if (isCrease[from]) continue;
    for (let c = 0; c < 4; c++) texels[2][vertex * 4 + c] = (change[from * 4 + c] ?? 0) * radius * radius;
  }
  for (const [i, name] of names.entries()) geometry.setAttribute(name, new BufferAttribute(texels[i] ?? texels[0], 4));
}

const corners = [new Vector3(), new Vector3(), new Vector3()] as const;
const face = new Vector3();
const other = new Vector3();

/** Whether each welded vertex is at a crease or a border. */
function findCreases({ triangles, edges, uses, usesOf, vertices }: MeshShape, positions: Float32Array): Uint8Array {
  const found = new Uint8Array(vertices.length);
  const normalOf = (use: number, into: Vector3): Vector3 => {
    for (let c = 0; c < 3; c++) corners[c]?.fromArray(positions, (triangles[(Math.abs(use) - 1) * 3 + c] ?? 0) * 3);
    const [a, b, c] = corners;
    return into.crossVectors(b.sub(a), c.sub(a));
  };
  for (let i = 0; i * 2 < edges.length; i++) {
    const [one, two, ...more] = uses.subarray(usesOf[i], usesOf[i + 1]);
    const isSmooth =
      one !== undefined && two !== undefined && more.length === 0 && normalOf(one, face).angleTo(normalOf(two, other)) < CREASE_RAD;
    if (isSmooth) continue;
    found[edges[i * 2] ?? 0] = 1;
    found[edges[i * 2 + 1] ?? 0] = 1;
  }
  return found;
}
