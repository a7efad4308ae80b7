import { Vector3 } from 'three';
import type { MeshShape } from '../../volumes/mesh-shape.ts';

/** Normals, tangent frames and areas of the vertices of a mesh; three numbers per vector. */
export interface TangentFrames {
  /**
   * Unit normals, averaged over the faces by their angle at the vertex (Thürmer and Wüthrich 1998). Where the faces cancel each other, as in
   * meshes that have each triangle twice, once for either side, the normal is that of the side of the vertex's first face.
   */
  readonly normals: Float64Array;
  /** A unit tangent per vertex, and the one that completes the right-handed frame (tangent, bitangent, normal). */
  readonly tangents: Float64Array;
  readonly bitangents: Float64Array;
  /** Part of the area that belongs to each vertex; the parts of a triangle are its own area. */
  readonly areas: Float64Array;
  /** Per corner of a triangle: its part of the area. */
  readonly cornerAreas: Float64Array;
}

const corners = [new Vector3(), new Vector3(), new Vector3()] as const;
const edges = [new Vector3(), new Vector3(), new Vector3()] as const;
const face = new Vector3();
const facing = new Vector3();
const axis = new Vector3();

/** A sum of normals whose squared length is below this has no direction. The angles that weight them are in radians. */
const CANCELED = 1e-12;

/**
 * @param positions Three numbers per welded vertex.
 */
export function tangentFrames({ triangles }: MeshShape, positions: Float32Array): TangentFrames {
  const normals = new Float64Array(positions.length);
  // The same sum, of the normals turned to the side of the first face.
  const ofSide = new Float64Array(positions.length);
  const areas = new Float64Array(positions.length / 3);
  const cornerAreas = new Float64Array(triangles.length);
  for (let i = 0; i < triangles.length; i += 3) {
    for (let c = 0; c < 3; c++) corners[c]?.fromArray(positions, (triangles[i + c] ?? 0) * 3);
    const [a, b, c] = corners;
    edges[0].subVectors(c, b);
    edges[1].subVectors(a, c);
    edges[2].subVectors(b, a);
    const area = face.crossVectors(edges[2], edges[0]).length() / 2;
    if (area === 0) continue;
    face.divideScalar(2 * area);
    const parts = partsOf(area);
    for (let k = 0; k < 3; k++) {
      const vertex = triangles[i + k] ?? 0;
      cornerAreas[i + k] = parts[k] ?? 0;
      areas[vertex] = (areas[vertex] ?? 0) + (parts[k] ?? 0);
      const [next, last] = [edges[(k + 2) % 3] ?? face, edges[(k + 1) % 3] ?? face];
      const angle = Math.PI - next.angleTo(last);
      add(normals, vertex, face, angle);
      add(ofSide, vertex, face, facing.fromArray(ofSide, vertex * 3).dot(face) < 0 ? -angle : angle);
    }
  }
  const tangents = new Float64Array(positions.length);
  const bitangents = new Float64Array(positions.length);
  for (let at = 0; at < normals.length; at += 3) {
    face.fromArray(normals, at);
    if (face.lengthSq() < CANCELED) face.fromArray(ofSide, at);
    // Triangles without area have no normal. A morph target may give them one, but directions are computed at rest.
    if (face.lengthSq() < CANCELED) face.set(0, 1, 0);
    face.normalize().toArray(normals, at);
    const [x, y, z] = [Math.abs(face.x), Math.abs(face.y), Math.abs(face.z)];
    // The axis that is farthest from the normal.
    axis.set(x <= y && x <= z ? 1 : 0, y < x && y <= z ? 1 : 0, z < x && z < y ? 1 : 0);
    axis.cross(face).normalize().toArray(tangents, at);
    axis.crossVectors(face, axis).toArray(bitangents, at);
  }
  return { normals, tangents, bitangents, areas, cornerAreas };
}

/** The parts of a triangle that are nearest to its corners (Meyer et al. 2003, section 3.3), from its edges opposite to them. */
function partsOf(area: number): readonly number[] {
  const squares = edges.map((edge) => edge.lengthSq());
  const [a = 0, b = 0, c = 0] = squares;
  const obtuse = [b + c < a, c + a < b, a + b < c];
  if (obtuse.includes(true)) return obtuse.map((here) => (here ? area / 2 : area / 4));
  const cotangents = [b + c - a, c + a - b, a + b - c].map((twice) => twice / (4 * area));
  return [0, 1, 2].map((k) => {
    const [next, last] = [(k + 1) % 3, (k + 2) % 3];
    return ((squares[next] ?? 0) * (cotangents[next] ?? 0) + (squares[last] ?? 0) * (cotangents[last] ?? 0)) / 8;
  });
}

function add(into: Float64Array, vertex: number, vector: Vector3, weight: number): void {
  into[vertex * 3] = (into[vertex * 3] ?? 0) + vector.x * weight;
  into[vertex * 3 + 1] = (into[vertex * 3 + 1] ?? 0) + vector.y * weight;
  into[vertex * 3 + 2] = (into[vertex * 3 + 2] ?? 0) + vector.z * weight;
}

const between = new Vector3();

/** Turns a vector as the shortest rotation turns one unit normal to another. */
export function turnBetween(vector: Vector3, from: Vector3, to: Vector3): Vector3 {
  const cosine = from.dot(to);
  // Opposite normals have no shortest rotation.
  if (cosine <= -0.9999) return vector.negate();
  between.addVectors(from, to).multiplyScalar(vector.dot(to) / (1 + cosine));
  return vector.sub(between);
}
