import type { CaptureMesh } from '../../capture.ts';

/**
 * The mean direction of the triangles around each vertex, larger triangles counting more.
 *
 * @returns Four signed bytes per vertex, of which the last is 0: a unit vector times 127. Zeros where the triangles cancel out.
 *
 * @example
 * const normals = vertexNormals(capture.mesh);
 */
export function vertexNormals({ positions, indices }: CaptureMesh): Int8Array<ArrayBuffer> {
  const sums = new Float32Array(positions.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * (indices[i] ?? 0), 3 * (indices[i + 1] ?? 0), 3 * (indices[i + 2] ?? 0)];
    const at = (vertex: number, axis: number): number => positions[vertex + axis] ?? 0;
    for (let axis = 0; axis < 3; axis++) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const area = (at(b, u) - at(a, u)) * (at(c, v) - at(a, v)) - (at(b, v) - at(a, v)) * (at(c, u) - at(a, u));
      for (const vertex of [a, b, c]) sums[vertex + axis] = (sums[vertex + axis] ?? 0) + area;
    }
  }
  const normals = new Int8Array((4 * positions.length) / 3);
  for (let vertex = 0; 3 * vertex < sums.length; vertex++) {
    const [x = 0, y = 0, z = 0] = sums.subarray(3 * vertex, 3 * vertex + 3);
    const length = Math.hypot(x, y, z);
    if (length > 0)
      normals.set(
        [x, y, z].map((part) => Math.round((127 * part) / length)),
        4 * vertex,
      );
  }
  return normals;
}
