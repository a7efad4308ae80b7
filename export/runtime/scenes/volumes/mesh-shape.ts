import type { BufferGeometry } from 'three';

/** Triangles of a mesh over welded vertices, and the edges between them. */
export interface MeshShape {
  /** Per welded vertex, one vertex of the geometry that stands there. */
  readonly vertices: Uint32Array;
  /** Three welded vertices per triangle, counter-clockwise seen from outside. */
  readonly triangles: Uint32Array;
  /** Two welded vertices per edge, the lower one first. */
  readonly edges: Uint32Array;
  /** Uses of edge i stand in `uses` from `usesOf[i]` to before `usesOf[i + 1]`. */
  readonly usesOf: Uint32Array;
  /** Triangles at an edge: t + 1 where t goes from the lower vertex to the higher one, -(t + 1) where it goes back. */
  readonly uses: Int32Array;
  /** Every edge is passed as often one way as the other: the surface has an inside and no border. */
  readonly closed: boolean;
}

/**
 * Finds the edges of a mesh. Vertices are one where they agree in place, skin and morphs: a seam in normals or UVs is no border, while
 * lips that only touch at rest may open.
 *
 * @param isUsed whether the material of this index takes part; geometries without groups ask for 0
 */
export function createMeshShape(geometry: BufferGeometry, isUsed: (materialIndex: number) => boolean): MeshShape {
  const welded = weld(geometry);
  const triangles = collectTriangles(geometry, welded.indexOf, isUsed);
  return { vertices: welded.vertices, triangles, ...collectEdges(triangles, welded.vertices.length) };
}

/** Parts of a mesh's radius below which two places are one: the seam of a computed ball closes to 17 digits only. */
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
    // Adding 0 makes -0 the same as 0.
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

function collectEdges(triangles: Uint32Array, vertexCount: number): Pick<MeshShape, 'edges' | 'usesOf' | 'uses' | 'closed'> {
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
