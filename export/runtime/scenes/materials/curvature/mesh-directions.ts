import { BufferAttribute, type BufferGeometry, type Mesh } from 'three';
import { createMeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { curvatureOf } from './curvature.ts';
import { directionField, levelField } from './direction-field.ts';
import { isTooLarge } from './mesh-limit.ts';
import { tangentFrames } from './tangent-frames.ts';

const ALONG = 'scrimAlong';
const SMOOTH_NORMAL = 'scrimSmoothNormal';

/** Geometries whose directions follow the curvature. */
const curved = new WeakSet<BufferGeometry>();

/**
 * Adds the attributes `scrimAlong`, the direction field of a mesh at rest, and `scrimSmoothNormal`, the normals of its welded vertices, to
 * its geometry, once. Both are unit vectors in units of the mesh.
 *
 * @param isCurved Whether the directions follow the curvature. Otherwise, and on meshes that are too large for that, they are level.
 */
export function ensureDirections(master: Mesh, isCurved: boolean): void {
  const { geometry } = master;
  const { position } = geometry.attributes;
  const follows = isCurved && !isTooLarge(geometry);
  if (!position || (geometry.attributes[ALONG] && (curved.has(geometry) || !follows))) return;
  const shape = createMeshShape(geometry, () => true);
  const positions = restVertices(master, shape);
  const frames = tangentFrames(shape, positions);
  const directions = follows ? directionField(shape, positions, frames, curvatureOf(shape, positions, frames)) : levelField(frames);
  if (follows) curved.add(geometry);
  const along = attributeOf(geometry, ALONG);
  const normals = attributeOf(geometry, SMOOTH_NORMAL);
  for (let vertex = 0; vertex < position.count; vertex++) {
    const from = (shape.weldedOf[vertex] ?? 0) * 3;
    along.array.set(directions.subarray(from, from + 3), vertex * 3);
    normals.array.set(frames.normals.subarray(from, from + 3), vertex * 3);
  }
  along.needsUpdate = true;
  normals.needsUpdate = true;
}

/** The attribute of a geometry; the same again if there is one, because three.js would keep the buffer of one that is replaced. */
function attributeOf(geometry: BufferGeometry, name: string): BufferAttribute {
  const known = geometry.attributes[name];
  if (known instanceof BufferAttribute) return known;
  const made = new BufferAttribute(new Float32Array((geometry.attributes.position?.count ?? 0) * 3), 3);
  geometry.setAttribute(name, made);
  return made;
}
