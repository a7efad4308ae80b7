import { expect, test } from '@jest/globals';
import { DOME_EYE_M, DOME_RADIUS_M, makeDomeMesh } from './dome-mesh.ts';

test('the dome is closed, seen from inside, level below, and as far away as it says', () => {
  const { positions, indices } = makeDomeMesh();
  const vertex = (i: number) => [...positions.subarray(3 * i, 3 * i + 3)] as [number, number, number];
  const edges = new Map<string, number>();
  let volume = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [0, 1, 2].map((k) => indices[i + k] ?? 0);
    const [a, b, c] = corners.map(vertex) as [[number, number, number], [number, number, number], [number, number, number]];
    // Six times the volume of the tetrahedron with the camera: negative if the camera sees the triangle counter-clockwise.
    const six = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    expect(six).toBeLessThan(0);
    volume -= six / 6;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3] ?? 0;
      edges.set(`${from} ${to}`, (edges.get(`${from} ${to}`) ?? 0) + 1);
    });
  }
  for (const [edge, count] of edges) expect([count, edges.get(edge.split(' ').reverse().join(' '))]).toEqual([1, 1]);
  // A ball without the cap below the floor: (2 / 3) r³ + r² h − h³ / 3, times π.
  const whole = Math.PI * ((2 / 3) * DOME_RADIUS_M ** 3 + DOME_RADIUS_M ** 2 * DOME_EYE_M - DOME_EYE_M ** 3 / 3);
  expect(volume / whole).toBeGreaterThan(0.99);
  expect(volume / whole).toBeLessThan(1);
  const heights = Array.from({ length: positions.length / 3 }, (_, i) => vertex(i)[1]);
  expect(Math.min(...heights)).toBeCloseTo(-DOME_EYE_M, 5);
  for (let i = 0; i < heights.length; i++) {
    const [x, y, z] = vertex(i);
    if (y > -DOME_EYE_M + 1e-4) expect(Math.hypot(x, y, z)).toBeCloseTo(DOME_RADIUS_M, 4);
  }
});
