import type { DepthMap } from './depth-map.ts';
import type { DepthMesh } from './depth-mesh.ts';
import type { DepthRays } from './depth-rays.ts';
import { createTriangleTests } from './triangle-tests.ts';

/** Sides of new triangles, pixels. Few are larger, and each is compared with many pixels. */
const MOST_SIDE_PX = 24;
/** And as a part of the width of a 360° map, where the edges of large triangles bend. */
const MOST_SIDE_AROUND = 1 / 32;
/** A vertex of more triangles stays. */
const MOST_AROUND = 32;

/**
 * Leaves out the vertices of a depth mesh that its quadtree needs but its surface does not. Most of them are near outlines, where blocks are
 * small. A vertex is left out if triangles from one of its neighbors show all pixels around it within the tolerance of the mesh, and none of
 * them is torn. A vertex of an outline is left out only if it is between its two neighbors there, so that outlines stay as they are.
 */
export function thinDepthMesh(mesh: DepthMesh, map: DepthMap, rays: DepthRays): DepthMesh {
  const { places, depths, tolerance } = mesh;
  const { widthPx, heightPx } = map;
  const tests = createTriangleTests(map, rays, tolerance);
  const triangles = createTriangles(depths.length, mesh.indices);
  const star = createStar();
  const mostSide = rays.wraps ? Math.min(MOST_SIDE_PX, widthPx * MOST_SIDE_AROUND) : MOST_SIDE_PX;
  const { ring, columns, rows } = star;

  const columnOf = (vertex: number): number => ((places[2 * vertex] ?? 1) - 1) / 2;
  const rowOf = (vertex: number): number => ((places[2 * vertex + 1] ?? 1) - 1) / 2;
  const readPlaces = (column: number): void => {
    for (let i = 0; i < star.size; i++) {
      const beside = columnOf(ring[i] ?? 0);
      // Columns go on beyond the seam of a 360° map.
      const isBeyond = rays.wraps && Math.abs(beside - column) > widthPx / 2;
      columns[i] = !isBeyond ? beside : beside < column ? beside + widthPx : beside - widthPx;
      rows[i] = rowOf(ring[i] ?? 0);
    }
  };
  const isGood = (a: number, b: number, c: number): boolean => {
    const [ax, bx, cx] = [columns[a] ?? 0, columns[b] ?? 0, columns[c] ?? 0];
    const [ay, by, cy] = [rows[a] ?? 0, rows[b] ?? 0, rows[c] ?? 0];
    if (twiceArea(ax, ay, bx, by, cx, cy) <= 0) return false;
    if (Math.max(ax, bx, cx) - Math.min(ax, bx, cx) > mostSide || Math.max(ay, by, cy) - Math.min(ay, by, cy) > mostSide) return false;
    return tests.fits(ax, ay, bx, by, cx, cy) && !tests.isTorn(pixelOf(a), pixelOf(b), pixelOf(c));
  };
  const pixelOf = (i: number): number => rowOf(ring[i] ?? 0) * widthPx + columnOf(ring[i] ?? 0);
  const showAll = (i: number): boolean => {
    const last = star.isClosed ? star.size : star.size - 1;
    for (let j = 0; j < last; j++) {
      const k = (j + 1) % star.size;
      if (j !== i && k !== i && !isGood(i, j, k)) return false;
    }
    return true;
  };
  const leaveOut = (vertex: number): void => {
    const [column, row] = [columnOf(vertex), rowOf(vertex)];
    // The rows at the poles of a 360° map are joined to the poles.
    if (rays.wraps && (row <= 0 || row >= heightPx - 1)) return;
    if (!star.read(vertex, triangles)) return;
    readPlaces(column);
    if (!star.isClosed && !isBetween(star, column, row)) return;
    // Where the nearest two neighbors cannot replace the vertex, the others hardly ever can.
    const nearest = star.nearest(column, row, -1);
    const other = star.nearest(column, row, nearest);
    if (showAll(nearest)) triangles.merge(vertex, ring[nearest] ?? 0);
    else if (showAll(other)) triangles.merge(vertex, ring[other] ?? 0);
  };
  for (let vertex = 0; vertex < depths.length; vertex++) leaveOut(vertex);
  return withIndices(mesh, triangles.indices());
}

/** Whether a vertex of an outline is between its two neighbors there. */
function isBetween({ columns, rows, size }: Star, x: number, y: number): boolean {
  const [ax, ay, bx, by] = [columns[0] ?? 0, rows[0] ?? 0, columns[size - 1] ?? 0, rows[size - 1] ?? 0];
  return twiceArea(ax, ay, x, y, bx, by) === 0 && (ax - x) * (bx - x) + (ay - y) * (by - y) < 0;
}

/** Twice the area of a triangle; negative if it is counterclockwise. */
function twiceArea(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/** The neighbors of a vertex, clockwise, with their columns and rows. They are read one vertex at a time. */
interface Star {
  readonly ring: Int32Array;
  readonly columns: Int32Array;
  readonly rows: Int32Array;
  readonly size: number;
  /** Whether the last neighbor is beside the first; otherwise the vertex is on an outline, and so are these two. */
  readonly isClosed: boolean;
  /** Returns false if there are not two triangles or more in one row or circle. */
  read(vertex: number, triangles: Triangles): boolean;
  /** Place in the ring of the nearest neighbor that may replace the vertex at a column and row, other than a place. */
  nearest(column: number, row: number, other: number): number;
}

function createStar(): Star {
  const list = (): Int32Array => new Int32Array(MOST_AROUND + 1);
  const [ring, columns, rows, from, to] = [list(), list(), list(), list(), list()];
  const star = {
    ...{ ring, columns, rows },
    size: 0,
    isClosed: false,
    read: (vertex: number, triangles: Triangles): boolean => {
      let count = 0;
      for (let corner = triangles.first(vertex); corner >= 0; corner = triangles.next(corner)) {
        if (count === MOST_AROUND) return false;
        from[count] = triangles.vertexOf(following(corner));
        to[count] = triangles.vertexOf(following(following(corner)));
        count++;
      }
      if (count < 2) return false;
      let at = 0;
      for (let i = 0; i < count; i++) if (indexIn(to, from[i] ?? 0, count) < 0) at = i;
      ring[0] = from[at] ?? 0;
      for (let i = 1; i <= count; i++) {
        if (at < 0) return false;
        ring[i] = to[at] ?? 0;
        at = indexIn(from, to[at] ?? 0, count);
      }
      star.isClosed = ring[count] === ring[0];
      star.size = star.isClosed ? count : count + 1;
      for (let i = 1; i < star.size; i++) if (indexIn(ring, ring[i] ?? 0, i) >= 0) return false;
      return star.size >= 3;
    },
    nearest: (column: number, row: number, other: number): number => {
      let [least, place] = [Number.POSITIVE_INFINITY, 0];
      for (let i = 0; i < star.size; i += star.isClosed ? 1 : star.size - 1) {
        const squared = ((columns[i] ?? 0) - column) ** 2 + ((rows[i] ?? 0) - row) ** 2;
        if (i === other || squared >= least) continue;
        least = squared;
        place = i;
      }
      return place;
    },
  };
  return star;
}

function indexIn(list: Int32Array, value: number, count: number): number {
  for (let i = 0; i < count; i++) if (list[i] === value) return i;
  return -1;
}

/** The next corner of the same triangle. */
function following(corner: number): number {
  return corner % 3 === 2 ? corner - 2 : corner + 1;
}

/** Triangles by their vertices. A corner is a place in the list of indices. */
interface Triangles {
  vertexOf(corner: number): number;
  /** The first corner that is a vertex, and the next one; -1 at the end. */
  first(vertex: number): number;
  next(corner: number): number;
  /** Moves a vertex to a neighbor. */
  merge(vertex: number, neighbor: number): void;
  indices(): Uint32Array;
}

function createTriangles(vertexCount: number, indices: Uint32Array): Triangles {
  const corners = Int32Array.from(indices);
  const firsts = new Int32Array(vertexCount).fill(-1);
  const followers = new Int32Array(corners.length).fill(-1);
  const add = (corner: number): void => {
    const vertex = corners[corner] ?? 0;
    followers[corner] = firsts[vertex] ?? -1;
    firsts[vertex] = corner;
  };
  const remove = (corner: number): void => {
    const vertex = corners[corner] ?? 0;
    let at = firsts[vertex] ?? -1;
    if (at === corner) firsts[vertex] = followers[corner] ?? -1;
    else {
      while (followers[at] !== corner) at = followers[at] ?? -1;
      followers[at] = followers[corner] ?? -1;
    }
  };
  for (let corner = 0; corner < corners.length; corner++) add(corner);
  return {
    vertexOf: (corner) => corners[corner] ?? 0,
    first: (vertex) => firsts[vertex] ?? -1,
    next: (corner) => followers[corner] ?? -1,
    merge: (vertex, neighbor) => {
      for (let corner = firsts[vertex] ?? -1; corner >= 0; corner = firsts[vertex] ?? -1) {
        const [b, c] = [following(corner), following(following(corner))];
        if (corners[b] === neighbor || corners[c] === neighbor) {
          for (const gone of [corner, b, c]) remove(gone);
          for (const gone of [corner, b, c]) corners[gone] = -1;
        } else {
          remove(corner);
          corners[corner] = neighbor;
          add(corner);
        }
      }
    },
    indices: () => Uint32Array.from(corners.filter((vertex) => vertex >= 0)),
  };
}

/** The mesh with other triangles, and without vertices that none of them has. */
function withIndices({ places, depths, tolerance }: DepthMesh, indices: Uint32Array): DepthMesh {
  const numbers = new Int32Array(depths.length).fill(-1);
  const kept: number[] = [];
  const renumbered = indices.map((vertex) => {
    if (numbers[vertex] === -1) numbers[vertex] = kept.push(vertex) - 1;
    return numbers[vertex] ?? 0;
  });
  return {
    places: new Uint16Array(kept.flatMap((vertex) => [places[2 * vertex] ?? 0, places[2 * vertex + 1] ?? 0])),
    depths: new Float32Array(kept.map((vertex) => depths[vertex] ?? 0)),
    indices: renumbered,
    tolerance,
  };
}
