import { BufferAttribute, type Mesh } from 'three';
import { createMeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { curvatureOf } from './curvature.ts';
import { directionField } from './direction-field.ts';
import { tangentFrames } from './tangent-frames.ts';

const ALONG = 'scrimAlong';
const SMOOTH_NORMAL = 'scrimSmoothNormal';

/**
 * Adds the attributes `scrimAlong`, the direction field of a mesh at rest, and `scrimSmoothNormal`, the normals of its welded vertices, to
 * its geometry, once. Both are unit vectors in units of the mesh.
 */
export function ensureDirections(master: Mesh): void {
  const { geometry } = master;
  const { position } = geometry.attributes;
  if (!position || geometry.attributes[ALONG]) return;
  const shape = createMeshShape(geometry, () => true);
  const positions = restVertices(master, shape);
  const frames = tangentFrames(shape, positions);
  const directions = directionField(shape, positions, frames, curvatureOf(shape, positions, frames));
  const along = new Float32Array(position.count * 3);
  const normals = new Float32Array(position.count * 3);
  for (let vertex = 0; vertex < position.count; vertex++) {
    const from = (shape.weldedOf[vertex] ?? 0) * 3;
    along.set(directions.subarray(from, from + 3), vertex * 3);
    normals.set(frames.normals.subarray(from, from + 3), vertex * 3);
  }
  geometry.setAttribute(ALONG, new BufferAttribute(along, 3));
  geometry.setAttribute(SMOOTH_NORMAL, new BufferAttribute(normals, 3));
}
