import type { SkinnedMesh } from 'three';
import { type Drawable, isSkinned } from '../proxies/drawable.ts';
import type { MeshShape, WeldedTriangles } from './mesh-shape.ts';

/** Whether skin or morph targets may move the vertices of a mesh per frame. */
export function isDeformed(master: Drawable): boolean {
  return isSkinned(master) || (master.morphTargetInfluences?.length ?? 0) > 0;
}

/**
 * Computes the current positions of welded vertices in local space, as three.js' `morphtarget_vertex` and `skinning_vertex` do.
 *
 * @param rest Positions of the geometry, three numbers each.
 * @param into Receives three numbers per vertex.
 */
export function poseVertices(master: Drawable, shape: MeshShape, rest: Float32Array, into: Float32Array): void {
  into.set(rest);
  morph(master, shape, into);
  if (isSkinned(master)) skin(master, shape, into);
}

/** Positions of the geometry at rest, three numbers per welded vertex. */
export function restVertices({ geometry }: Drawable, { vertices }: WeldedTriangles): Float32Array {
  const rest = new Float32Array(vertices.length * 3);
  const { position } = geometry.attributes;
  if (!position) return rest;
  for (let i = 0; i < vertices.length; i++) {
    const vertex = vertices[i] ?? 0;
    rest[i * 3] = position.getX(vertex);
    rest[i * 3 + 1] = position.getY(vertex);
    rest[i * 3 + 2] = position.getZ(vertex);
  }
  return rest;
}

function morph({ geometry, morphTargetInfluences }: Drawable, { vertices }: MeshShape, into: Float32Array): void {
  const targets = geometry.morphAttributes.position;
  if (!targets || !morphTargetInfluences) return;
  let base = 1;
  if (!geometry.morphTargetsRelative) for (const influence of morphTargetInfluences) base -= influence;
  if (base !== 1) for (let i = 0; i < into.length; i++) into[i] = (into[i] ?? 0) * base;
  for (let t = 0; t < targets.length; t++) {
    const target = targets[t];
    const influence = morphTargetInfluences[t] ?? 0;
    if (!target || influence === 0) continue;
    for (let i = 0; i < vertices.length; i++) {
      const vertex = vertices[i] ?? 0;
      into[i * 3] = (into[i * 3] ?? 0) + influence * target.getX(vertex);
      into[i * 3 + 1] = (into[i * 3 + 1] ?? 0) + influence * target.getY(vertex);
      into[i * 3 + 2] = (into[i * 3 + 2] ?? 0) + influence * target.getZ(vertex);
    }
  }
}

/** First three rows of the matrix of one vertex. Valid within one call. */
const scratchMatrix = new Float64Array(12);

function skin({ geometry, skeleton, bindMatrix, bindMatrixInverse }: SkinnedMesh, { vertices }: MeshShape, into: Float32Array): void {
  const { skinIndex, skinWeight } = geometry.attributes;
  skeleton.update();
  const bones = skeleton.boneMatrices;
  if (!skinIndex || !skinWeight || !bones) return;
  const bind = bindMatrix.elements;
  const unbind = bindMatrixInverse.elements;
  const m = scratchMatrix;
  for (let i = 0; i < vertices.length; i++) {
    const vertex = vertices[i] ?? 0;
    m.fill(0);
    for (let k = 0; k < 4; k++) {
      const weight = skinWeight.getComponent(vertex, k);
      if (weight === 0) continue;
      const bone = skinIndex.getComponent(vertex, k) * 16;
      for (let column = 0; column < 4; column++) {
        for (let row = 0; row < 3; row++) {
          m[column * 3 + row] = (m[column * 3 + row] ?? 0) + weight * (bones[bone + column * 4 + row] ?? 0);
        }
      }
    }
    apply(bind, 4, into, i * 3);
    apply(m, 3, into, i * 3);
    apply(unbind, 4, into, i * 3);
  }
}

/** Transforms the point at `at` by a column-major affine matrix whose columns have `rows` elements. */
function apply(matrix: ArrayLike<number>, rows: 3 | 4, points: Float32Array, at: number): void {
  const x = points[at] ?? 0;
  const y = points[at + 1] ?? 0;
  const z = points[at + 2] ?? 0;
  for (let row = 0; row < 3; row++) {
    points[at + row] =
      (matrix[row] ?? 0) * x + (matrix[rows + row] ?? 0) * y + (matrix[2 * rows + row] ?? 0) * z + (matrix[3 * rows + row] ?? 0);
  }
}
