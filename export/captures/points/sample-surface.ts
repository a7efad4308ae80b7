import type { CaptureMesh } from '../../../nodes/kit/capture.ts';

/** Steps of the additive recurrence R2 (Roberts 2018), whose points are spread evenly over a square. */
const STEPS = [0.7548776662466927, 0.5698402909980532] as const;

/**
 * Points that are spread over a mesh by area, always the same ones.
 *
 * @param count Number of points, at most; fewer for a mesh without area.
 * @returns x, y, z of each, in the space of the mesh.
 */
export function sampleSurface({ positions, indices }: CaptureMesh, count: number): Float32Array {
  const at = (corner: number, axis: number): number => positions[3 * (indices[corner] ?? 0) + axis] ?? 0;
  const areas = new Float64Array(indices.length / 3);
  let total = 0;
  for (let i = 0; i < areas.length; i++) {
    const [a, b] = [1, 2].map((corner) => [0, 1, 2].map((axis) => at(3 * i + corner, axis) - at(3 * i, axis))) as [number[], number[]];
    const cross = (p: number, q: number): number => (a[p] ?? 0) * (b[q] ?? 0) - (a[q] ?? 0) * (b[p] ?? 0);
    total += Math.hypot(cross(1, 2), cross(2, 0), cross(0, 1)) / 2;
    areas[i] = total;
  }
  if (total === 0) return new Float32Array(0);
  const points = new Float32Array(3 * count);
  let triangle = 0;
  for (let point = 0; point < count; point++) {
    while ((areas[triangle] ?? 0) < ((point + 0.5) / count) * total) triangle++;
    let [u, v] = STEPS.map((step) => (step * (point + 1)) % 1) as [number, number];
    if (u + v > 1) [u, v] = [1 - u, 1 - v];
    for (let axis = 0; axis < 3; axis++) {
      const from = at(3 * triangle, axis);
      points[3 * point + axis] = from + u * (at(3 * triangle + 1, axis) - from) + v * (at(3 * triangle + 2, axis) - from);
    }
  }
  return points;
}
