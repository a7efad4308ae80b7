import type { BufferGeometry } from 'three';
import { buildTriangleTree, type TriangleTree } from './triangle-tree.ts';

/** The triangles of a geometry. They are computed once per geometry, and again after a change of its buffers. */
export interface GeometryTriangles {
  /** Indices of vertices, three per triangle. */
  readonly vertices: Uint32Array;
  /** A tree for casting rays at the triangles in rest position: without skinning and morphing. */
  readonly tree: TriangleTree;
}

interface Kept extends GeometryTriangles {
  readonly of: Buffers;
}

interface Buffers {
  readonly position: object;
  readonly positionVersion: number;
  readonly index: object | null;
  readonly indexVersion: number;
  readonly start: number;
  readonly count: number;
}

/** The triangles of each geometry, shared by all Pick nodes. An entry is garbage-collected with its geometry. */
const kept = new WeakMap<BufferGeometry, Kept>();

/**
 * The triangles of a geometry within its draw range.
 *
 * @returns Null for a geometry without positions.
 */
export function trianglesOf(geometry: BufferGeometry): GeometryTriangles | null {
  const { position } = geometry.attributes;
  if (!position) return null;
  const known = kept.get(geometry);
  if (known && isCurrent(known.of, geometry)) return known;
  const made = { ...build(geometry), of: buffersOf(geometry) };
  kept.set(geometry, made);
  return made;
}

function isCurrent(of: Buffers, { attributes, index, drawRange }: BufferGeometry): boolean {
  const { position } = attributes;
  return (
    position !== undefined &&
    of.position === position &&
    of.positionVersion === versionOf(position) &&
    of.index === index &&
    of.indexVersion === (index?.version ?? 0) &&
    of.start === drawRange.start &&
    of.count === drawRange.count
  );
}

function buffersOf({ attributes, index, drawRange }: BufferGeometry): Buffers {
  const { position } = attributes;
  if (!position) throw new Error('The geometry has no positions.');
  return {
    position,
    positionVersion: versionOf(position),
    index,
    indexVersion: index?.version ?? 0,
    start: drawRange.start,
    count: drawRange.count,
  };
}

/** The version of an attribute's data. Interleaved attributes have that of the buffer they share. */
function versionOf(attribute: NonNullable<BufferGeometry['attributes'][string]>): number {
  return 'data' in attribute ? attribute.data.version : attribute.version;
}

function build({ attributes, index, drawRange }: BufferGeometry): GeometryTriangles {
  const { position } = attributes;
  const available = index?.count ?? position?.count ?? 0;
  const end = Math.min(available, drawRange.start + drawRange.count);
  const count = Math.max(0, Math.floor((end - drawRange.start) / 3));
  const vertices = new Uint32Array(3 * count);
  const corners = new Float32Array(9 * count);
  for (let i = 0; i < vertices.length; i++) {
    const vertex = index ? index.getX(drawRange.start + i) : drawRange.start + i;
    vertices[i] = vertex;
    corners[3 * i] = position?.getX(vertex) ?? Number.NaN;
    corners[3 * i + 1] = position?.getY(vertex) ?? Number.NaN;
    corners[3 * i + 2] = position?.getZ(vertex) ?? Number.NaN;
  }
  return { vertices, tree: buildTriangleTree(corners) };
}
