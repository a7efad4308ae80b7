import { BackSide, DoubleSide, type InstancedMesh, type Material, Matrix4, type Mesh, type Object3D, Sphere, Vector3 } from 'three';
import type { Ray } from '../../kit/hit-test.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import { type GeometryTriangles, trianglesOf } from './geometry-triangles.ts';
import { createPosedTriangles, type PosedTriangles } from './posed-triangles.ts';
import { castAtTree, type Sides, type TriangleHit } from './triangle-tree.ts';

/** The object that a ray meets first. Owned by the caller. */
export interface ObjectHit {
  /** The object; null if the ray meets none. */
  item: ObjectItem | null;
  mesh: Object3D | null;
  /** Index of the object list that contains the item. */
  list: number;
  /** Index of the instance of an instanced mesh; 0 for other meshes. */
  copy: number;
  distanceM: number;
  /** Normal of the triangle, world space, of any length. */
  readonly normal: Vector3;
}

export function createObjectHit(): ObjectHit {
  return { item: null, mesh: null, list: 0, copy: 0, distanceM: 0, normal: new Vector3(0, 1, 0) };
}

// Filled and read within one call.
const scratchRay: Ray = { ox: 0, oy: 0, oz: 0, dx: 0, dy: 0, dz: -1 };
const scratchHit: TriangleHit = { along: 0, nx: 0, ny: 1, nz: 0 };
const scratchOrigin = new Vector3();
const scratchAhead = new Vector3();
const scratchPoint = new Vector3();
const scratchWorldFromMesh = new Matrix4();
const scratchWorldFromCopy = new Matrix4();
const scratchMeshFromWorld = new Matrix4();
const scratchSphere = new Sphere();

/** The posed triangles of skinned and morphed meshes. An entry is garbage-collected with its mesh. */
const posed = new WeakMap<Mesh, { readonly of: GeometryTriangles; readonly triangles: PosedTriangles }>();

/**
 * Finds the first object that a ray meets: meshes as they are posed in this frame, with the sides that their materials show. Lines, points
 * and invisible objects are not met.
 *
 * @param out Its `item` is null where nothing is met.
 * @param worldFromRay Column-major 4×4, rigid: the ray starts at its origin, along its -z axis.
 */
export function castAtObjects(out: ObjectHit, worldFromRay: ArrayLike<number>, lists: readonly ObjectList[]): void {
  const at = (i: number): number => worldFromRay[i] ?? 0;
  scratchOrigin.set(at(12), at(13), at(14));
  scratchAhead.set(-at(8), -at(9), -at(10)).normalize();
  out.item = null;
  out.mesh = null;
  out.copy = 0;
  out.distanceM = Number.POSITIVE_INFINITY;
  for (let l = 0; l < lists.length; l++) {
    const items = lists[l]?.items;
    for (let i = 0; items && i < items.length; i++) {
      const item = items[i];
      if (item && !item.hidden && item.pickable !== false && castAtSubtree(out, item, item.root)) out.list = l;
    }
  }
}

function castAtSubtree(out: ObjectHit, item: ObjectItem, object: Object3D): boolean {
  if (!object.visible) return false;
  let found = isMesh(object) && castAtMesh(out, item, object);
  const { children } = object;
  for (let i = 0; i < children.length; i++) {
    const child = children[i];
    if (child) found = castAtSubtree(out, item, child) || found;
  }
  return found;
}

function castAtMesh(out: ObjectHit, item: ObjectItem, mesh: Mesh): boolean {
  const { material } = mesh;
  if (!Array.isArray(material) && !material.visible) return false;
  const sides = Array.isArray(material) ? 0 : sidesOf(material);
  scratchWorldFromMesh.multiplyMatrices(item.worldFromObject, mesh.matrixWorld);
  if (!isInstanced(mesh)) return castAtPlaced(out, item, mesh, scratchWorldFromMesh, 0, sides);
  let found = false;
  for (let copy = 0; copy < mesh.count; copy++) {
    scratchWorldFromCopy.fromArray(mesh.instanceMatrix.array, 16 * copy).premultiply(scratchWorldFromMesh);
    found = castAtPlaced(out, item, mesh, scratchWorldFromCopy, copy, sides) || found;
  }
  return found;
}

/** Casts the ray at one mesh, or at one instance of a mesh. Skinning and morphing of instanced meshes are ignored. */
function castAtPlaced(out: ObjectHit, item: ObjectItem, mesh: Mesh, worldFromMesh: Matrix4, copy: number, sides: Sides): boolean {
  const isPosed = 'isSkinnedMesh' in mesh || (mesh.morphTargetInfluences?.length ?? 0) > 0;
  if (!isPosed && !meetsBounds(mesh, worldFromMesh, out.distanceM)) return false;
  const geometry = trianglesOf(mesh.geometry);
  if (!geometry || worldFromMesh.determinant() === 0) return false;
  scratchMeshFromWorld.copy(worldFromMesh).invert();
  // Lengths along the ray stay those of the world, because its direction is not normalized.
  scratchPoint.copy(scratchOrigin).applyMatrix4(scratchMeshFromWorld);
  scratchRay.ox = scratchPoint.x;
  scratchRay.oy = scratchPoint.y;
  scratchRay.oz = scratchPoint.z;
  scratchPoint.copy(scratchOrigin).add(scratchAhead).applyMatrix4(scratchMeshFromWorld);
  scratchRay.dx = scratchPoint.x - scratchRay.ox;
  scratchRay.dy = scratchPoint.y - scratchRay.oy;
  scratchRay.dz = scratchPoint.z - scratchRay.oz;
  scratchHit.along = out.distanceM;
  const isMet = isPosed
    ? posedOf(mesh, geometry).cast(scratchHit, scratchRay, sides)
    : castAtTree(scratchHit, geometry.tree, scratchRay, sides);
  if (!isMet) return false;
  out.item = item;
  out.mesh = mesh;
  out.copy = copy;
  out.distanceM = scratchHit.along;
  // Normals are transformed by the inverse transpose.
  const m = scratchMeshFromWorld.elements;
  const { nx, ny, nz } = scratchHit;
  out.normal.set(m[0] * nx + m[1] * ny + m[2] * nz, m[4] * nx + m[5] * ny + m[6] * nz, m[8] * nx + m[9] * ny + m[10] * nz);
  return true;
}

/** Whether the ray meets the sphere around a geometry before `limitM`. */
function meetsBounds({ geometry }: Mesh, worldFromMesh: Matrix4, limitM: number): boolean {
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  if (!geometry.boundingSphere) return false;
  const { center, radius } = scratchSphere.copy(geometry.boundingSphere).applyMatrix4(worldFromMesh);
  const alongM = scratchPoint.subVectors(center, scratchOrigin).dot(scratchAhead);
  const asideSquared = scratchPoint.lengthSq() - alongM * alongM;
  return asideSquared <= radius * radius * (1 + 1e-6) && alongM + radius >= 0 && alongM - radius <= limitM;
}

function posedOf(mesh: Mesh, geometry: GeometryTriangles): PosedTriangles {
  const known = posed.get(mesh);
  if (known?.of === geometry) return known.triangles;
  const triangles = createPosedTriangles(mesh, geometry);
  posed.set(mesh, { of: geometry, triangles });
  return triangles;
}

function sidesOf({ side }: Material): Sides {
  return side === DoubleSide ? 0 : side === BackSide ? -1 : 1;
}

function isMesh(object: Object3D): object is Mesh {
  return 'isMesh' in object;
}

function isInstanced(mesh: Mesh): mesh is InstancedMesh {
  return 'isInstancedMesh' in mesh;
}
