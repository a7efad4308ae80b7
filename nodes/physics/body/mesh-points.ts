import {
  type BufferAttribute,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type Object3D,
  Vector3,
} from 'three';

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

function pointsOf(mesh: Mesh, scale: Vector3): MeshPoints {
  const position = mesh.geometry.attributes.position as BufferAttribute | InterleavedBufferAttribute;
  const out = new Float64Array(3 * position.count * instancesOf(mesh));
  let length = 0;
  for (let i = 0; i < instancesOf(mesh); i++) {
    matrix.copy(mesh.matrixWorld);
    if (isInstanced(mesh)) {
      mesh.getMatrixAt(i, instance);
      matrix.multiply(instance);
    }
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
