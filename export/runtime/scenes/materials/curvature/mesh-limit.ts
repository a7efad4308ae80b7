import type { BufferGeometry } from 'three';

/**
 * Maximum number of triangles of a mesh whose curvature is computed. It blocks the page: 150,000 triangles take 2 s of CPU time on a server,
 * and their directions 0.7 s more.
 */
const MAX_TRIANGLES = 200_000;

/** Whether a mesh is too large for its curvature to be computed. */
export function isTooLarge({ index, attributes }: BufferGeometry): boolean {
  return (index?.count ?? attributes.position?.count ?? 0) / 3 > MAX_TRIANGLES;
}
