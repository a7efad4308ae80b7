import { Vector3 } from 'three';
import type { TriangleEdges, WeldedTriangles } from '../../volumes/mesh-shape.ts';
import { type LineRoom, measureRoom } from './line-room.ts';

/** An edge of a mesh with its faces, by welded vertices: (a, b, c) and (b, a, d), both counterclockwise from outside. */
export interface MeshEdge {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  /** Third vertex of the other face; -1 at a border. */
  readonly d: number;
  /** Angle between the faces in radians: 0 if they are coplanar, negative if they are concave, π at a border. */
  readonly angle: number;
}

/** Part of an edge, and its place in the stroke that it belongs to. */
export interface EdgeSegment {
  readonly edge: MeshEdge;
  /** Where the segment starts and ends, from 0 at vertex a to 1 at vertex b. It points along its stroke. */
  readonly from: number;
  readonly to: number;
  /** Lengths in units of the mesh, from the start of the stroke to the start and to the end of the segment. */
  readonly alongFrom: number;
  readonly alongTo: number;
  /** Length of the stroke; 0 if the edge belongs to no stroke. */
  readonly stroke: number;
  /** How far apart lines lie around the start and the end, in units of the mesh; infinite where there are few. */
  readonly roomFrom: number;
  readonly roomTo: number;
}

/** Triangles and their edges. */
export type EdgedTriangles = Pick<WeldedTriangles, 'triangles'> & Pick<TriangleEdges, 'edges' | 'usesOf' | 'uses'>;

/** From this angle on, an edge belongs to a stroke. */
const FEATURE_RAD = 0.4;

/** Cosine of the largest angle by which a stroke turns from one edge to the next. */
const STRAIGHT = Math.cos(0.7);

/** Below this angle, an edge of a mesh that does not bend is never visible as a line: its faces are coplanar. */
const COPLANAR_RAD = 1e-3;

/** Segments are at most this part of the size of the mesh, so that long edges can be drawn in waves. */
const SEGMENTS_ACROSS = 40;

// Valid within one call.
const scratchFrom = new Vector3();
const scratchAlong = new Vector3();
const scratchNext = new Vector3();
const scratchOpposite = new Vector3();
const scratchFace = new Vector3();

/**
 * Finds the edges of a mesh that may be drawn as lines, cut into segments.
 *
 * @param positions Three numbers per welded vertex.
 * @param bends Whether the mesh is skinned or morphed: then an edge that is flat or concave at rest may become a silhouette.
 * @param limit Maximum number of segments.
 * @returns The segments; null if there are more than `limit`.
 */
export function findSegments(shape: EdgedTriangles, positions: Float32Array, bends: boolean, limit: number): readonly EdgeSegment[] | null {
  const edges = findEdges(shape, positions).filter(({ angle }) => bends || angle > COPLANAR_RAD || angle < -FEATURE_RAD);
  if (edges.length > limit) return null;
  const longest = sizeOf(positions) / SEGMENTS_ACROSS;
  const lengthOf = ({ a, b }: MeshEdge): number =>
    scratchFrom.fromArray(positions, a * 3).distanceTo(scratchAlong.fromArray(positions, b * 3));
  const segments: EdgeSegment[] = [];
  const room = measureRoom(edges, positions);
  const cut = (edge: MeshEdge, reversed: boolean, start: number, stroke: number): number => {
    const length = lengthOf(edge);
    const count = Math.max(1, Math.ceil(length / longest));
    const at = (t: number): number => (reversed ? 1 - t : t);
    const along = (t: number): number => (stroke === 0 ? 0 : start + length * t);
    for (let i = 0; i < count; i++) {
      const [from, to] = [i / count, (i + 1) / count];
      const [roomFrom, roomTo] = [roomAt(room, positions, edge, at(from)), roomAt(room, positions, edge, at(to))];
      segments.push({ edge, from: at(from), to: at(to), alongFrom: along(from), alongTo: along(to), stroke, roomFrom, roomTo });
    }
    return start + length;
  };
  const inStroke = new Set<MeshEdge>();
  for (const stroke of findStrokes(positions, edges)) {
    const total = stroke.reduce((sum, { edge }) => sum + lengthOf(edge), 0);
    let start = 0;
    for (const { edge, reversed } of stroke) {
      inStroke.add(edge);
      start = cut(edge, reversed, start, total);
    }
  }
  for (const edge of edges) if (!inStroke.has(edge)) cut(edge, false, 0, 0);
  return segments.length > limit ? null : segments;
}

function roomAt(room: LineRoom, positions: Float32Array, { a, b }: MeshEdge, t: number): number {
  const { x, y, z } = scratchNext.fromArray(positions, a * 3).lerp(scratchOpposite.fromArray(positions, b * 3), t);
  return room(x, y, z);
}

/** Diagonal of the bounding box. */
function sizeOf(positions: Float32Array): number {
  const low = scratchFrom.setScalar(Number.POSITIVE_INFINITY);
  const high = scratchAlong.setScalar(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < positions.length; i += 3) {
    scratchNext.fromArray(positions, i);
    low.min(scratchNext);
    high.max(scratchNext);
  }
  return positions.length === 0 ? 0 : low.distanceTo(high);
}

/** The edges of a mesh. Of an edge with more than two faces, two that run in opposite directions count. */
function findEdges({ triangles, edges, usesOf, uses }: EdgedTriangles, positions: Float32Array): MeshEdge[] {
  const found: MeshEdge[] = [];
  for (let i = 0; i * 2 < edges.length; i++) {
    const all = uses.subarray(usesOf[i], usesOf[i + 1]);
    const low = edges[i * 2] ?? 0;
    const high = edges[i * 2 + 1] ?? 0;
    const opposite = (use: number): number => {
      const triangle = (Math.abs(use) - 1) * 3;
      for (let corner = 0; corner < 3; corner++) {
        const vertex = triangles[triangle + corner] ?? 0;
        if (vertex !== low && vertex !== high) return vertex;
      }
      return low;
    };
    const first = all[0] ?? 1;
    const second = all.find((use) => use * first < 0);
    const [a, b] = first > 0 ? [low, high] : [high, low];
    const c = opposite(first);
    const d = second === undefined ? -1 : opposite(second);
    found.push({ a, b, c, d, angle: d < 0 ? Math.PI : angleOf(positions, a, b, c, d) });
  }
  return found;
}

function angleOf(positions: Float32Array, a: number, b: number, c: number, d: number): number {
  const from = scratchFrom.fromArray(positions, a * 3);
  const along = scratchAlong.fromArray(positions, b * 3).sub(from);
  const other = scratchOpposite.fromArray(positions, d * 3).sub(from);
  const face = scratchFace.crossVectors(along, scratchNext.fromArray(positions, c * 3).sub(from));
  const next = scratchNext.crossVectors(other, along);
  // Faces without area have no direction.
  if (face.lengthSq() === 0 || next.lengthSq() === 0) return 0;
  return face.dot(other) > 0 ? -face.angleTo(next) : face.angleTo(next);
}

interface StrokePart {
  readonly edge: MeshEdge;
  /** Whether the stroke runs from b to a. */
  readonly reversed: boolean;
}

const turned = ({ edge, reversed }: StrokePart): StrokePart => ({ edge, reversed: !reversed });

/** Chains creases and borders to strokes, each as long as it is nearly straight from edge to edge. */
function findStrokes(positions: Float32Array, edges: readonly MeshEdge[]): StrokePart[][] {
  const features = edges.filter(({ angle }) => Math.abs(angle) >= FEATURE_RAD);
  const around = new Map<number, MeshEdge[]>();
  for (const edge of features) {
    for (const end of [edge.a, edge.b]) {
      const known = around.get(end);
      if (known) known.push(edge);
      else around.set(end, [edge]);
    }
  }
  const taken = new Set<MeshEdge>();
  const direction = ({ edge: { a, b }, reversed }: StrokePart, into: Vector3): Vector3 => {
    into.fromArray(positions, (reversed ? a : b) * 3);
    return into.sub(scratchFrom.fromArray(positions, (reversed ? b : a) * 3)).normalize();
  };
  /** The free edge at the end of a part that continues it most straightly. */
  const next = (part: StrokePart): StrokePart | null => {
    const end = part.reversed ? part.edge.a : part.edge.b;
    const along = direction(part, scratchAlong);
    let best: StrokePart | null = null;
    let straightest = STRAIGHT;
    for (const edge of around.get(end) ?? []) {
      if (taken.has(edge)) continue;
      const candidate = { edge, reversed: edge.b === end };
      const straight = direction(candidate, scratchNext).dot(along);
      if (straight < straightest) continue;
      straightest = straight;
      best = candidate;
    }
    return best;
  };
  const follow = (first: StrokePart): StrokePart[] => {
    const parts: StrokePart[] = [];
    for (let part = next(first); part; part = next(part)) {
      taken.add(part.edge);
      parts.push(part);
    }
    return parts;
  };
  return features.flatMap((edge) => {
    if (taken.has(edge)) return [];
    taken.add(edge);
    const first = { edge, reversed: false };
    const after = follow(first);
    const before = follow(turned(first)).reverse().map(turned);
    return [[...before, first, ...after]];
  });
}
