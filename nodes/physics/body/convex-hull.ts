import { Vector3 } from 'three';
import { ConvexHull, type Face, type VertexNode } from 'three/examples/jsm/math/ConvexHull.js';
import type { BodyShape, Triple } from '../../kit/physics.ts';
import type { MeshPoints } from './mesh-points.ts';

/** The most vertices of a hull: the time for contacts of two hulls grows with the product of their numbers of edges. */
export const MAX_VERTICES = 40;
/** The most points that quickhull gets. A larger set is reduced to the points that are farthest in this many directions. */
const MAX_QUICKHULL = 400;
/** Cosine of the angle below which two faces count as coplanar and are merged. */
const COS_COPLANAR = Math.cos((2 * Math.PI) / 180);

/**
 * The convex hull of points: quickhull (Barber et al. 1996, three's `ConvexHull`), reduced to `MAX_VERTICES`, with coplanar triangles
 * merged into one face, because a contact polygon is clipped against a whole face.
 *
 * @returns Null for points without volume.
 */
export function hullOf(points: MeshPoints): Extract<BodyShape, { kind: 'hull' }> | null {
  let vertices = toVectors(points);
  if (vertices.length > MAX_QUICKHULL) vertices = furthest(vertices, MAX_QUICKHULL);
  let hull = facesOf(vertices);
  if (hull && hull.verticesM.length > MAX_VERTICES) {
    const reduced = furthest(
      hull.verticesM.map((vertex) => new Vector3(...vertex)),
      MAX_VERTICES,
    );
    hull = facesOf(reduced);
  }
  return hull;
}

function toVectors(points: MeshPoints): Vector3[] {
  const seen = new Map<string, Vector3>();
  for (let i = 0; i < points.length; i += 3) {
    const vector = new Vector3(points[i], points[i + 1], points[i + 2]);
    // A tenth of a millimeter apart is the same vertex: quickhull misbehaves on slivers.
    seen.set(`${Math.round(vector.x * 1e4)} ${Math.round(vector.y * 1e4)} ${Math.round(vector.z * 1e4)}`, vector);
  }
  return [...seen.values()];
}

/** Selects up to `count` points: those that are farthest along evenly spread directions (a Fibonacci lattice) and along the axes. */
function furthest(points: readonly Vector3[], count: number): Vector3[] {
  const chosen = new Set<Vector3>();
  const direction = new Vector3();
  const addFurthest = (): void => {
    let best: Vector3 | undefined;
    let most = Number.NEGATIVE_INFINITY;
    for (const point of points) {
      const d = point.dot(direction);
      if (d > most) {
        most = d;
        best = point;
      }
    }
    if (best) chosen.add(best);
  };
  for (let axis = 0; axis < 3; axis++) {
    direction.set(0, 0, 0).setComponent(axis, 1);
    addFurthest();
    direction.negate();
    addFurthest();
  }
  const golden = Math.PI * (3 - Math.sqrt(5));
  for (let i = 0; chosen.size < count && i < count - 6; i++) {
    const y = 1 - (2 * (i + 0.5)) / (count - 6);
    const r = Math.sqrt(1 - y * y);
    direction.set(Math.cos(golden * i) * r, y, Math.sin(golden * i) * r);
    addFurthest();
  }
  return [...chosen];
}

function facesOf(points: Vector3[]): Extract<BodyShape, { kind: 'hull' }> | null {
  if (points.length < 4) return null;
  const { faces } = new ConvexHull().setFromPoints(points);
  if (faces.length < 4) return null;
  const groups = groupCoplanar(faces);
  const index = new Map<VertexNode, number>();
  const verticesM: Triple[] = [];
  const polygons: number[][] = [];
  for (const group of groups) {
    const loop = outlineOf(group);
    if (loop.length < 3) return null;
    polygons.push(
      loop.map((node) => {
        const known = index.get(node);
        if (known !== undefined) return known;
        index.set(node, verticesM.length);
        verticesM.push([node.point.x, node.point.y, node.point.z]);
        return verticesM.length - 1;
      }),
    );
  }
  return verticesM.length < 4 || polygons.length < 4 ? null : { kind: 'hull', verticesM, faces: polygons };
}

/** Groups neighboring faces that are coplanar. */
function groupCoplanar(faces: readonly Face[]): ReadonlySet<Face>[] {
  const open = new Set(faces);
  const groups: ReadonlySet<Face>[] = [];
  // The largest first, whose normal is the most exact.
  for (const first of [...faces].sort((a, b) => b.area - a.area)) {
    if (!open.delete(first)) continue;
    const group = new Set([first]);
    for (const face of group) {
      for (const { twin } of edgesOf(face)) {
        const other = twin?.face;
        if (!other || !open.has(other) || other.normal.dot(first.normal) < COS_COPLANAR) continue;
        open.delete(other);
        group.add(other);
      }
    }
    groups.push(group);
  }
  return groups;
}

function edgesOf(face: Face): Face['edge'][] {
  const edges: Face['edge'][] = [];
  let edge = face.edge;
  do {
    edges.push(edge);
    edge = edge.next;
  } while (edge !== face.edge);
  return edges;
}

/** Returns the corners of a group of faces, counterclockwise. */
function outlineOf(group: ReadonlySet<Face>): VertexNode[] {
  const next = new Map<VertexNode, VertexNode>();
  for (const face of group) {
    for (const edge of edgesOf(face)) {
      const inside = edge.twin && group.has(edge.twin.face);
      const tail = edge.prev.vertex;
      if (!inside) next.set(tail, edge.vertex);
    }
  }
  const [start] = next.keys();
  const loop: VertexNode[] = [];
  let at = start;
  while (at && loop.length < next.size) {
    loop.push(at);
    at = next.get(at);
    if (at === start) break;
  }
  return loop;
}
