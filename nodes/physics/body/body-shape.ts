import type { BufferGeometry, Mesh, Object3D, Vector3 } from 'three';
import type { BodyMode, BodyShape, Triple } from '../../kit/physics.ts';
import { hullOf } from './convex-hull.ts';
import { MAX_POINTS, type MeshPoints, meshPoints, meshTriangles } from './mesh-points.ts';
import { boxShape, capsuleShapes, cylinderShape, sphereShape } from './solids.ts';

export type ShapeKind = 'auto' | 'box' | 'sphere' | 'cylinder' | 'capsule' | 'hull' | 'parts' | 'mesh';

export interface ShapeResult {
  readonly shapes: readonly BodyShape[];
  /** Why the shape is not of the requested kind, as a sentence that begins with the object; null if it is. */
  readonly problem: string | null;
}

/** The least thickness of a body; thinner ones would pass through each other. */
const MIN_SIZE_M = 0.002;
/** Size of the body of an object that has no vertices or no size. */
const NO_SIZE_M: Triple = [0.01, 0.01, 0.01];
/** The most parts of a compound. */
const MAX_PARTS = 16;

/** The geometries of three.js that are solids with a body shape of their own. */
const SOLIDS: Readonly<Record<string, ShapeKind>> = {
  BoxGeometry: 'box',
  SphereGeometry: 'sphere',
  CylinderGeometry: 'cylinder',
  CapsuleGeometry: 'capsule',
};

/**
 * Computes the body shape of an object at a scale, in the axes of the object. The size of box, sphere, cylinder and capsule is that of the
 * bounding box.
 *
 * @param scale Factors on x, y and z of the object.
 * @param mode What moves the body. Triangles are no shape for forces; where nothing moves the body, “auto” takes them instead of a hull.
 */
export function shapeOf(kind: ShapeKind, root: Object3D, scale: Vector3, mode: BodyMode = 'dynamic'): ShapeResult {
  const meshes = meshPoints(root, scale);
  if (!meshes) return { shapes: [boxOfGeometry(root, scale)], problem: `The object has more than ${MAX_POINTS} vertices.` };
  const bounds = boundsOf(meshes);
  if (!bounds) return { shapes: [boxShape(NO_SIZE_M)], problem: 'The object has no vertices.' };
  const { size, center } = bounds;
  const largest = Math.max(...size);
  if (largest < MIN_SIZE_M) return { shapes: [boxShape(NO_SIZE_M, center)], problem: 'The object has no size.' };
  const wanted = kind === 'auto' ? kindOf(root, mode) : kind;
  if (wanted === 'mesh' && mode !== 'dynamic') return { shapes: [meshTriangles(root, scale)], problem: null };
  const isFlat = Math.min(...size) < Math.max(MIN_SIZE_M / 2, 1e-4 * largest);
  if (isFlat && wanted !== 'box') return { shapes: [boxShape(thick(size), center)], problem: 'The object is flat.' };
  switch (wanted) {
    case 'box':
      return { shapes: [boxShape(thick(size), center)], problem: null };
    case 'sphere':
      return { shapes: [sphereShape(largest / 2, center)], problem: null };
    case 'cylinder':
      return { shapes: [cylinderShape(size, center)], problem: null };
    case 'capsule':
      return { shapes: capsuleShapes(size, center), problem: null };
    case 'mesh':
      return { shapes: hulls([merge(meshes)], size, center).shapes, problem: 'The object is moved by forces.' };
    case 'hull':
    case 'auto':
      return hulls([merge(meshes)], size, center);
    case 'parts':
      return hulls(meshes.slice(0, MAX_PARTS), size, center);
  }
}

function hulls(parts: readonly MeshPoints[], size: Triple, center: Triple): ShapeResult {
  const shapes = parts.flatMap((points) => hullOf(points) ?? []);
  if (shapes.length > 0) return { shapes, problem: null };
  return { shapes: [boxShape(thick(size), center)], problem: 'The object has no volume.' };
}

/**
 * The kind of shape that fits the geometry, if the object is a single solid of three.js; otherwise the triangles of what nothing moves, or
 * the convex hull.
 */
function kindOf(root: Object3D, mode: BodyMode): ShapeKind {
  const other = mode === 'static' ? 'mesh' : 'hull';
  const geometry = (root as Partial<Mesh>).geometry as BufferGeometry | undefined;
  return root.children.length === 0 && geometry ? (SOLIDS[geometry.type] ?? other) : other;
}

function merge(meshes: readonly MeshPoints[]): MeshPoints {
  const merged = new Float64Array(meshes.reduce((sum, { length }) => sum + length, 0));
  let offset = 0;
  for (const points of meshes) {
    merged.set(points, offset);
    offset += points.length;
  }
  return merged;
}

function boundsOf(meshes: readonly MeshPoints[]): { readonly size: Triple; readonly center: Triple } | null {
  const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY] as [number, number, number];
  const most = least.map((x) => -x) as [number, number, number];
  for (const points of meshes) {
    for (let i = 0; i < points.length; i++) {
      const axis = (i % 3) as 0 | 1 | 2;
      const value = points[i] ?? 0;
      least[axis] = Math.min(least[axis], value);
      most[axis] = Math.max(most[axis], value);
    }
  }
  if (least[0] > most[0]) return null;
  return {
    size: [most[0] - least[0], most[1] - least[1], most[2] - least[2]],
    center: [(most[0] + least[0]) / 2, (most[1] + least[1]) / 2, (most[2] + least[2]) / 2],
  };
}

function thick(size: Triple): Triple {
  return [Math.max(size[0], MIN_SIZE_M), Math.max(size[1], MIN_SIZE_M), Math.max(size[2], MIN_SIZE_M)];
}

/** Computes a box from the bounding boxes of the geometries, for meshes with too many vertices to read each. */
function boxOfGeometry(root: Object3D, scale: Vector3): BodyShape {
  const corners: number[] = [];
  root.traverse((object) => {
    const { geometry } = object as Partial<Mesh>;
    if (!geometry) return;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    const box = geometry.boundingBox?.clone().applyMatrix4(object.matrixWorld);
    if (box) corners.push(...box.min.multiply(scale).toArray(), ...box.max.multiply(scale).toArray());
  });
  const bounds = boundsOf([Float64Array.from(corners.filter(Number.isFinite))]);
  return bounds ? boxShape(thick(bounds.size), bounds.center) : boxShape(NO_SIZE_M);
}
