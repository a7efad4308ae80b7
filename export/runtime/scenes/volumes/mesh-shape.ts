import type { BufferGeometry } from 'three';

/** Triangles over welded vertices. */
export interface WeldedTriangles {
  /** For each welded vertex, the index of one of its vertices in the geometry. */
  readonly vertices: Uint32Array;
  /** Three welded vertices per triangle, counterclockwise from outside. */
  readonly triangles: Uint32Array;
}

/** Edges of triangles. */
export interface TriangleEdges {
  /** Two welded vertices per edge, the lower one first. */
  readonly edges: Uint32Array;
  /** Uses of edge i are in `uses` from `usesOf[i]` to before `usesOf[i + 1]`. */
  readonly usesOf: Uint32Array;
  /** Triangles at an edge: t + 1 if t traverses it from the lower to the higher vertex, -(t + 1) otherwise. */
  readonly uses: Int32Array;
  /** Whether every edge is traversed equally often in both directions, so that the surface has an inside and no border. */
  readonly closed: boolean;
}

/** Triangles of a mesh over welded vertices, and their edges. */
export interface MeshShape extends WeldedTriangles, TriangleEdges {
  /** For each vertex of the geometry, its welded vertex. */
  readonly weldedOf: Uint32Array;
}

/** Finds the edges of a mesh, over vertices that `weldTriangles` welds. */
export function createMeshShape(geometry: BufferGeometry, isUsed: (materialIndex: number) => boolean): MeshShape {
  const welded = weldTriangles(geometry, isUsed);
  return { ...welded, ...collectEdges(welded.triangles, welded.vertices.length) };
}

/**
 * Finds the triangles of a mesh. Vertices are welded if position, skin and morph targets are equal: a seam in normals or UVs is not a border,
 * but lips that only touch at rest may open.
 *
 * @param isUsed Whether the material with this index takes part; for geometries without groups the index is 0.
 */
export function weldTriangles(
  geometry: BufferGeometry,
  isUsed: (materialIndex: number) => boolean,
): WeldedTriangles & Pick<MeshShape, 'weldedOf'> {
  const { vertices, indexOf } = weld(geometry);
  return { vertices, weldedOf: indexOf, triangles: collectTriangles(geometry, indexOf, isUsed) };
}

/** Tolerance for equal positions relative to the radius of the mesh, because computed seams differ by rounding. */
const SAME = 2 ** -20;

function weld(geometry: BufferGeometry): { vertices: Uint32Array; indexOf: Uint32Array } {
  const { position, skinIndex, skinWeight } = geometry.attributes;
  const count = position?.count ?? 0;
  const parts = [position, skinIndex, skinWeight, ...(geometry.morphAttributes.position ?? [])].filter((part) => part !== undefined);
  const indexOf = new Uint32Array(count);
  const vertices: number[] = [];
  const known = new Map<string, number>();
  const key: number[] = [];
  if (geometry.boundingSphere === null) geometry.computeBoundingSphere();
  const grid = 1 / ((geometry.boundingSphere?.radius || 1) * SAME);
  for (let i = 0; i < count; i++) {
    key.length = 0;
    // Adding 0 converts -0.
    for (const part of parts) {
      const scale = part === skinIndex || part === skinWeight ? 1 / SAME : grid;
      for (let c = 0; c < part.itemSize; c++) key.push(Math.round(part.getComponent(i, c) * scale) + 0);
    }
    const text = key.join();
    const found = known.get(text);
    indexOf[i] = found ?? vertices.length;
    if (found !== undefined) continue;
    known.set(text, vertices.length);
    vertices.push(i);
  }
  return { vertices: Uint32Array.from(vertices), indexOf };
}

function collectTriangles(geometry: BufferGeometry, indexOf: Uint32Array, isUsed: (materialIndex: number) => boolean): Uint32Array {
  const { index, drawRange } = geometry;
  const total = index?.count ?? indexOf.length;
  const first = drawRange.start;
  const end = Math.min(total, first + drawRange.count);
  const groups = geometry.groups.length > 0 ? geometry.groups : [{ start: 0, count: total, materialIndex: 0 }];
  const triangles: number[] = [];
  const at = (i: number): number => indexOf[index ? index.getX(i) : i] ?? 0;
  for (const { start, count, materialIndex = 0 } of groups) {
    if (!isUsed(materialIndex)) continue;
    for (let i = Math.max(start, first); i + 2 < Math.min(start + count, end); i += 3) {
      const [a, b, c] = [at(i), at(i + 1), at(i + 2)];
      if (a !== b && b !== c && c !== a) triangles.push(a, b, c);
    }
  }
  return Uint32Array.from(triangles);
}

/** Finds the edges of triangles over welded vertices. */
export function collectEdges(triangles: Uint32Array, vertexCount: number): TriangleEdges {
  const usesByEdge = new Map<number, number[]>();
  for (let i = 0; i < triangles.length; i++) {
    const from = triangles[i] ?? 0;
    const to = triangles[i % 3 === 2 ? i - 2 : i + 1] ?? 0;
    const triangle = Math.floor(i / 3) + 1;
    const edge = Math.min(from, to) * vertexCount + Math.max(from, to);
    const uses = usesByEdge.get(edge);
    const use = from < to ? triangle : -triangle;
    if (uses) uses.push(use);
    else usesByEdge.set(edge, [use]);
  }
  const edges = new Uint32Array(usesByEdge.size * 2);
  const usesOf = new Uint32Array(usesByEdge.size + 1);
  const uses = new Int32Array(triangles.length);
  let closed = true;
  let count = 0;
  let edgeIndex = 0;
  for (const [edge, all] of usesByEdge) {
    edges[edgeIndex * 2] = Math.floor(edge / vertexCount);
    edges[edgeIndex * 2 + 1] = edge % vertexCount;
    uses.set(all, count);
    count += all.length;
    usesOf[++edgeIndex] = count;
    if (all.reduce((sum, use) => sum + Math.sign(use), 0) !== 0) closed = false;
  }
  return { edges, usesOf, uses, closed };
}
