/** An edge between two vertices. */
export interface AngledEdge {
  readonly a: number;
  readonly b: number;
  /** Angle between its faces in radians; its sign has no meaning here. */
  readonly angle: number;
}

/** Returns how far apart lines lie around a point of the mesh, in its units; infinite where there are few. */
export type LineRoom = (x: number, y: number, z: number) => number;

/** Cells along the longest side of the bounding box in the finest grid. Each coarser grid has half as many, the coarsest 4. */
const CELLS = 64;
const LEVELS = 5;

/** Lines through a cell from which on it is crowded, and from which on fully. A corner of a box counts 0.75, a thin rod 2. */
const CROWDED = 2;
const FULL = 4;

interface Grid {
  readonly cells: number;
  readonly cell: number;
  /** Expected length of lines in each cell. */
  readonly lengths: Float32Array;
}

/**
 * Measures how crowded the lines of edges are, in grids of several sizes. From a random direction, an edge is a silhouette as often as its
 * angle is a part of half a turn. So the sum of length × angle / π in a cell, divided by its side, is the number of lines that
 * cross it; the side divided by that number is their distance.
 */
export function measureRoom(edges: readonly AngledEdge[], positions: Float32Array): LineRoom {
  const low = [0, 1, 2].map((axis) => extreme(positions, axis, Math.min));
  const side = Math.max(...low.map((from, axis) => extreme(positions, axis, Math.max) - from));
  if (!(side > 0)) return () => Number.POSITIVE_INFINITY;
  const finest: Grid = { cells: CELLS, cell: side / CELLS, lengths: new Float32Array(CELLS ** 3) };
  const coordinate = (vertex: number, axis: number): number => (positions[vertex * 3 + axis] ?? 0) - (low[axis] ?? 0);
  for (const { a, b, angle } of edges) {
    const from = [0, 1, 2].map((axis) => coordinate(a, axis));
    const along = from.map((start, axis) => coordinate(b, axis) - start);
    const length = Math.hypot(...along);
    const pieces = Math.max(1, Math.ceil(length / finest.cell));
    for (let i = 0; i < pieces; i++) {
      const [x = 0, y = 0, z = 0] = from.map((start, axis) => cellAt(start + (along[axis] ?? 0) * ((i + 0.5) / pieces), finest));
      const index = (z * CELLS + y) * CELLS + x;
      finest.lengths[index] = (finest.lengths[index] ?? 0) + ((length / pieces) * Math.abs(angle)) / Math.PI;
    }
  }
  const grids = [finest];
  for (let fine = finest; grids.length < LEVELS; grids.push(fine)) fine = coarser(fine);
  return (x, y, z) => {
    const at = [x - (low[0] ?? 0), y - (low[1] ?? 0), z - (low[2] ?? 0)] as const;
    let room = Number.POSITIVE_INFINITY;
    for (const grid of grids) {
      const lines = interpolated(grid, at) / grid.cell;
      const crowded = Math.min(Math.max((lines - CROWDED) / (FULL - CROWDED), 0), 1);
      if (crowded > 0) room = Math.min(room, grid.cell / (lines * crowded));
    }
    return room;
  };
}

function extreme(positions: Float32Array, axis: number, of: (a: number, b: number) => number): number {
  let found = positions[axis] ?? 0;
  for (let i = axis; i < positions.length; i += 3) found = of(found, positions[i] ?? 0);
  return found;
}

function cellAt(coordinate: number, { cell, cells }: Grid): number {
  return Math.min(Math.max(Math.floor(coordinate / cell), 0), cells - 1);
}

function coarser({ cells, cell, lengths }: Grid): Grid {
  const half = cells / 2;
  const sums = new Float32Array(half ** 3);
  for (let z = 0; z < cells; z++) {
    for (let y = 0; y < cells; y++) {
      for (let x = 0; x < cells; x++) {
        const index = ((z >> 1) * half + (y >> 1)) * half + (x >> 1);
        sums[index] = (sums[index] ?? 0) + (lengths[(z * cells + y) * cells + x] ?? 0);
      }
    }
  }
  return { cells: half, cell: cell * 2, lengths: sums };
}

/** The mean of the eight nearest cells, weighted by their distances, so that neighboring points differ little. */
function interpolated(grid: Grid, [x, y, z]: readonly [number, number, number]): number {
  const { cell, cells, lengths } = grid;
  let sum = 0;
  for (let corner = 0; corner < 8; corner++) {
    let index = 0;
    let weight = 1;
    for (const [axis, coordinate] of [z, y, x].entries()) {
      const place = coordinate / cell - 0.5;
      const first = Math.floor(place);
      const isNext = (corner >> axis) & 1;
      index = index * cells + Math.min(Math.max(first + isNext, 0), cells - 1);
      weight *= isNext === 1 ? place - first : 1 - (place - first);
    }
    sum += weight * (lengths[index] ?? 0);
  }
  return sum;
}
