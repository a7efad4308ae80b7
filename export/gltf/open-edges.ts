import type { Gltf, GltfPrimitive } from './document.ts';
import { readNumbers } from './read-numbers.ts';

/** Edges of a model's surfaces that do not belong to exactly two triangles. */
export interface EdgeFaults {
  /** Edges with one triangle, at holes or borders. */
  readonly open: number;
  /** Edges with more than two triangles. */
  readonly branching: number;
}

/** Maximum number of triangles to check, which takes about 0.2 s. Larger models are not checked. */
const MAX_TRIANGLES = 300_000;

/**
 * Counts the edges at which a model's meshes are not closed. Vertices at the same position count as one, because files split them at seams.
 * Returns null if the geometry is compressed or too large.
 */
export function findEdgeFaults(gltf: Gltf): EdgeFaults | null {
  let open = 0;
  let branching = 0;
  let triangles = 0;
  for (const { primitives } of gltf.document.meshes ?? []) {
    const places = new Map<string, number>();
    const edges = new Map<number, number>();
    for (const primitive of primitives) {
      if ((primitive.mode ?? 4) !== 4) continue;
      const corners = cornerPlaces(gltf, primitive, places);
      if (!corners) return null;
      triangles += corners.length / 3;
      if (triangles > MAX_TRIANGLES) return null;
      countEdges(corners, edges);
    }
    for (const count of edges.values()) {
      if (count === 1) open++;
      else if (count > 2) branching++;
    }
  }
  return { open, branching };
}

/**
 * Number of steps between 0 and the largest coordinate, to which coordinates are rounded, because vertices at seams differ by rounding
 * errors.
 */
const PLACES = 2 ** 20;

/** Factor that combines the two vertices of an edge to one key; larger than any number of vertices that is checked. */
const STRIDE = 2 ** 24;

function countEdges(corners: Uint32Array, edges: Map<number, number>): void {
  for (let i = 0; i + 2 < corners.length; i += 3) {
    const triangle = [corners[i] as number, corners[i + 1] as number, corners[i + 2] as number] as const;
    const [a, b, c] = triangle;
    // A degenerate triangle closes nothing.
    if (a === b || b === c || c === a) continue;
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ] as const) {
      const key = Math.min(from, to) * STRIDE + Math.max(from, to);
      edges.set(key, (edges.get(key) ?? 0) + 1);
    }
  }
}

/** The index of each triangle corner's position, equal for equal positions. */
function cornerPlaces(gltf: Gltf, { attributes, indices, extensions }: GltfPrimitive, places: Map<string, number>): Uint32Array | null {
  if (extensions && 'KHR_draco_mesh_compression' in extensions) return null;
  const positions = readNumbers(gltf, attributes.POSITION);
  if (!positions) return null;
  const scale = PLACES / largestOf(positions);
  const placeOf = new Uint32Array(positions.length / 3);
  for (let i = 0; i < placeOf.length; i++) {
    const key = [0, 1, 2].map((c) => Math.round((positions[3 * i + c] ?? 0) * scale)).join(' ');
    let place = places.get(key);
    if (place === undefined) {
      place = places.size;
      places.set(key, place);
    }
    placeOf[i] = place;
  }
  if (indices === undefined) return placeOf;
  const corners = readNumbers(gltf, indices);
  return corners && Uint32Array.from(corners, (index) => placeOf[index] ?? 0);
}

/**
 * Whether a surface of the model may have a border. Vertices count as one if position, skin and morph targets are equal but for rounding; the
 * parts of a mesh with different materials are apart. True if it cannot be found out, as for compressed geometry.
 */
export function mayHaveBorders(gltf: Gltf): boolean {
  return (gltf.document.meshes ?? []).some(({ primitives }) => primitives.some((primitive) => isOpen(gltf, primitive)));
}

/** Modes of glTF's primitives that are points and lines. */
const LINE_STRIP = 3;
const TRIANGLES = 4;

function isOpen(gltf: Gltf, { mode = TRIANGLES, attributes, indices, targets = [], extensions = {} }: GltfPrimitive): boolean {
  if (mode <= LINE_STRIP) return false;
  if (mode !== TRIANGLES || 'KHR_draco_mesh_compression' in extensions) return true;
  const { POSITION, JOINTS_0, WEIGHTS_0 } = attributes;
  const count = POSITION === undefined ? 0 : (gltf.document.accessors?.[POSITION]?.count ?? 0);
  const used = [POSITION, JOINTS_0, WEIGHTS_0, ...targets.map((target) => target.POSITION)].filter((index) => index !== undefined);
  const parts = used.map((index) => readNumbers(gltf, index));
  const corners = indices === undefined ? Float64Array.from({ length: count }, (_, i) => i) : readNumbers(gltf, indices);
  if (corners === null || parts.includes(null)) return true;
  const scale = PLACES / largestOf(parts[0] ?? new Float64Array());
  const rounded = parts.map((part, i) => {
    const isSkin = used[i] === JOINTS_0 || used[i] === WEIGHTS_0;
    return part?.map((value) => Math.round(value * (isSkin ? PLACES : scale)) + 0) ?? new Float64Array();
  });
  const places = new Map<string, number>();
  const placeOf = Uint32Array.from({ length: count }, (_, vertex) => {
    const key = rounded.map((part) => part.subarray((vertex * part.length) / count, ((vertex + 1) * part.length) / count).join()).join(' ');
    const place = places.get(key) ?? places.size;
    places.set(key, place);
    return place;
  });
  return !isBalanced(Uint32Array.from(corners, (corner) => placeOf[corner] ?? 0));
}

function largestOf(positions: Float64Array): number {
  return positions.reduce((largest, x) => Math.max(largest, Math.abs(x)), Number.MIN_VALUE);
}

/** Whether triangles traverse each edge equally often in both directions. */
function isBalanced(corners: Uint32Array): boolean {
  const balance = new Map<number, number>();
  for (let i = 0; i < corners.length; i++) {
    const from = corners[i] ?? 0;
    const to = corners[i % 3 === 2 ? i - 2 : i + 1] ?? 0;
    const key = Math.min(from, to) * STRIDE + Math.max(from, to);
    balance.set(key, (balance.get(key) ?? 0) + Math.sign(to - from));
  }
  return [...balance.values()].every((sum) => sum === 0);
}
