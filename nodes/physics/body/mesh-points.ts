import {
  type BufferAttribute,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type Object3D,
  Vector3,
} from 'three';
import type { BodyShape } from '../../kit/physics.ts';

/**
 * The vertices of one mesh as x, y, z, in meters: in the axes of the object, multiplied by its scale. Vertices with numbers that are not
 * finite are left out.
 */
export type MeshPoints = Float64Array;

/** The most vertices from which a body is made. */
export const MAX_POINTS = 200_000;

const matrix = new Matrix4();
const instance = new Matrix4();
const point = new Vector3();

/** The vertices of all meshes of a subtree, in the rest pose of skinned meshes. Null if there are more than `MAX_POINTS`. */
export function meshPoints(root: Object3D, scale: Vector3): MeshPoints[] | null {
  const meshes: Mesh[] = [];
  let count = 0;
  root.traverse((object) => {
    if (!isMesh(object)) return;
    const vertices = object.geometry.attributes.position?.count ?? 0;
    count += vertices * instancesOf(object);
    if (vertices > 0) meshes.push(object);
  });
  if (count > MAX_POINTS) return null;
  return meshes.map((mesh) => pointsOf(mesh, scale));
}

/**
 * The triangles of all meshes of a subtree, in the axes of the object, multiplied by its scale. Those with numbers that are not finite are
 * left out.
 */
export function meshTriangles(root: Object3D, scale: Vector3): Extract<BodyShape, { kind: 'mesh' }> {
  const positions: number[] = [];
  const indices: number[] = [];
  root.traverse((object) => {
    if (!isMesh(object)) return;
    const { index } = object.geometry;
    const { position } = object.geometry.attributes;
    if (!position) return;
    const count = index?.count ?? position.count;
    for (let i = 0; i < instancesOf(object); i++) {
      const first = positions.length / 3;
      setMatrix(object, i);
      for (let j = 0; j < position.count; j++) {
        point.fromBufferAttribute(position, j).applyMatrix4(matrix).multiply(scale);
        positions.push(point.x, point.y, point.z);
      }
      for (let j = 0; j + 2 < count; j += 3) {
        const corners = [0, 1, 2].map((k) => first + (index ? index.getX(j + k) : j + k));
        if (corners.every((corner) => isFinitePoint(positions, corner))) indices.push(...corners);
      }
    }
  });
  // Vertices that no triangle has may have any numbers.
  return {
    kind: 'mesh',
    positionsM: Float32Array.from(positions, (x) => (Number.isFinite(x) ? x : 0)),
    indices: Uint32Array.from(indices),
  };
}

function isFinitePoint(positions: readonly number[], index: number): boolean {
  return Number.isFinite((positions[3 * index] ?? Number.NaN) + (positions[3 * index + 1] ?? 0) + (positions[3 * index + 2] ?? 0));
}

/** Writes the matrix of an instance of a mesh, in the axes of the object, to `matrix`. */
function setMatrix(mesh: Mesh, i: number): void {
  matrix.copy(mesh.matrixWorld);
  if (!isInstanced(mesh)) return;
  mesh.getMatrixAt(i, instance);
  matrix.multiply(instance);
}

function pointsOf(mesh: Mesh, scale: Vector3): MeshPoints {
  const position = mesh.geometry.attributes.position as BufferAttribute | InterleavedBufferAttribute;
  const out = new Float64Array(3 * position.count * instancesOf(mesh));
  let length = 0;
  for (let i = 0; i < instancesOf(mesh); i++) {
    setMatrix(mesh, i);
    for (let j = 0; j < position.count; j++) {
      point.fromBufferAttribute(position, j).applyMatrix4(matrix).multiply(scale);
      if (!Number.isFinite(point.x + point.y + point.z)) continue;
      out[length++] = point.x;
      out[length++] = point.y;
      out[length++] = point.z;
    }
  }
  return out.subarray(0, length);
}

function instancesOf(mesh: Mesh): number {
  return isInstanced(mesh) ? mesh.count : 1;
}

function isMesh(object: Object3D): object is Mesh {
  return (object as Partial<Mesh>).isMesh === true;
}

function isInstanced(mesh: Mesh): mesh is InstancedMesh {
  return (mesh as Partial<InstancedMesh>).isInstancedMesh === true;
}
