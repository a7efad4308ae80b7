import { BufferAttribute, BufferGeometry } from 'three';
import type { Distance, Vector } from './distance.ts';

/** Steps of Newton's method that move a vertex onto the surface. */
const STEPS = 3;
const RELAXATIONS = 3;
const AXES = [0, 1, 2] as const;

/**
 * The surface of a solid between two corners, as a closed mesh of triangles that are about `cellM` wide. Vertices lie on the surface, and
 * their normals are the gradient of the distance. S. F. Gibson, Constrained Elastic Surface Nets, 1998.
 *
 * @throws If the solid reaches the border of the box: its mesh would have a hole.
 */
export function meshOf(distance: Distance, low: Vector, high: Vector, cellM: number): BufferGeometry {
  const [nx, ny, nz] = low.map((from, i) => Math.ceil(((high[i] ?? 0) - from) / cellM) + 1) as unknown as Vector;
  const indexOf = (i: number, j: number, k: number) => (k * ny + j) * nx + i;
  const values = new Float64Array(nx * ny * nz);
  for (let k = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      for (let i = 0; i < nx; i++) {
        const value = distance(low[0] + i * cellM, low[1] + j * cellM, low[2] + k * cellM);
        values[indexOf(i, j, k)] = value;
        const atBorder = i === 0 || j === 0 || k === 0 || i === nx - 1 || j === ny - 1 || k === nz - 1;
        if (atBorder && value < 0) throw new Error(`The solid reaches the border of its box at cell ${i}, ${j}, ${k}.`);
      }
    }
  }
  const isInside = (i: number, j: number, k: number) => (values[indexOf(i, j, k)] ?? 0) < 0;

  const positions: number[] = [];
  const vertexOf = new Int32Array(nx * ny * nz).fill(-1);
  for (let k = 0; k < nz - 1; k++) {
    for (let j = 0; j < ny - 1; j++) {
      for (let i = 0; i < nx - 1; i++) {
        const inside = CORNERS.filter(([a, b, c]) => isInside(i + a, j + b, k + c)).length;
        if (inside === 0 || inside === 8) continue;
        vertexOf[indexOf(i, j, k)] = positions.length / 3;
        const at = meanCrossing(([a, b, c]) => values[indexOf(i + a, j + b, k + c)] ?? 0);
        positions.push(low[0] + (i + at[0]) * cellM, low[1] + (j + at[1]) * cellM, low[2] + (k + at[2]) * cellM);
      }
    }
  }

  const indices: number[] = [];
  const quad = (inwards: boolean, a: number, b: number, c: number, d: number) =>
    indices.push(...(inwards ? [a, c, b, b, c, d] : [a, b, c, b, d, c]));
  const vertex = (i: number, j: number, k: number) => vertexOf[indexOf(i, j, k)] ?? -1;
  for (let k = 1; k < nz - 1; k++) {
    for (let j = 1; j < ny - 1; j++) {
      for (let i = 1; i < nx - 1; i++) {
        const here = isInside(i, j, k);
        if (here !== isInside(i + 1, j, k)) quad(!here, vertex(i, j - 1, k - 1), vertex(i, j, k - 1), vertex(i, j - 1, k), vertex(i, j, k));
        if (here !== isInside(i, j + 1, k)) quad(here, vertex(i - 1, j, k - 1), vertex(i, j, k - 1), vertex(i - 1, j, k), vertex(i, j, k));
        if (here !== isInside(i, j, k + 1)) quad(!here, vertex(i - 1, j - 1, k), vertex(i, j - 1, k), vertex(i - 1, j, k), vertex(i, j, k));
      }
    }
  }

  for (let turn = 0; turn < RELAXATIONS; turn++) relax(distance, positions, indices, cellM);
  const normals: number[] = [];
  for (let i = 0; i < positions.length; i += 3) {
    const slope = slopeAt(distance, [positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0], cellM);
    const length = Math.hypot(...slope) || 1;
    normals.push(...slope.map((part) => part / length));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array(normals), 3));
  geometry.setIndex(indices);
  return geometry;
}

const CORNERS: readonly Vector[] = Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2] as const);
const EDGES = CORNERS.flatMap((from, i) =>
  CORNERS.slice(i + 1).flatMap((to) => (from.filter((part, axis) => part !== to[axis]).length === 1 ? [[from, to] as const] : [])),
);

/** Mean of the points at which the surface crosses the edges of a cell, in cells from its corner. */
function meanCrossing(valueAt: (corner: Vector) => number): Vector {
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (const [from, to] of EDGES) {
    const [a, b] = [valueAt(from), valueAt(to)];
    if (a < 0 === b < 0) continue;
    count++;
    for (const axis of AXES) sum[axis] += from[axis] + ((to[axis] - from[axis]) * a) / (a - b);
  }
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

/** Moves each vertex toward the mean of its neighbors and back to the surface, so that triangles get similar sizes. */
function relax(distance: Distance, positions: number[], indices: readonly number[], cellM: number): void {
  const sums = new Float64Array(positions.length);
  const counts = new Uint32Array(positions.length / 3);
  for (let i = 0; i < indices.length; i += 3) {
    for (const [a, b] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ] as const) {
      const [from, to] = [indices[i + a] ?? 0, indices[i + b] ?? 0];
      counts[from] = (counts[from] ?? 0) + 1;
      for (const axis of AXES) sums[from * 3 + axis] = (sums[from * 3 + axis] ?? 0) + (positions[to * 3 + axis] ?? 0);
    }
  }
  for (let i = 0; i < counts.length; i++) {
    const at = AXES.map((axis) => 0.5 * (positions[i * 3 + axis] ?? 0) + (0.5 * (sums[i * 3 + axis] ?? 0)) / (counts[i] ?? 1));
    const onto = ontoSurface(distance, at as unknown as Vector, cellM);
    for (const axis of AXES) positions[i * 3 + axis] = onto[axis];
  }
}

/** The point of the surface near another one, within a cell of it. */
function ontoSurface(distance: Distance, near: Vector, cellM: number): Vector {
  const at: [number, number, number] = [...near];
  for (let step = 0; step < STEPS; step++) {
    const slope = slopeAt(distance, at, cellM);
    const squared = Math.max(slope[0] ** 2 + slope[1] ** 2 + slope[2] ** 2, 0.04);
    const away = Math.min(Math.max(distance(...at) / squared, -0.3 * cellM), 0.3 * cellM);
    for (const axis of AXES) at[axis] -= away * slope[axis];
  }
  return at;
}

/** Gradient of the distance, by central differences over a tenth of a cell. */
function slopeAt(distance: Distance, [x, y, z]: Vector, cellM: number): Vector {
  const d = cellM * 0.05;
  return [
    (distance(x + d, y, z) - distance(x - d, y, z)) / (2 * d),
    (distance(x, y + d, z) - distance(x, y - d, z)) / (2 * d),
    (distance(x, y, z + d) - distance(x, y, z - d)) / (2 * d),
  ];
}
