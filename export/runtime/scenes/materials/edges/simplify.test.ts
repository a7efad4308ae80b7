import { describe, expect, test } from '@jest/globals';
import { type BufferGeometry, Mesh, PlaneGeometry, TorusGeometry } from 'three';
import { collectEdges, weldTriangles } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { simplify } from './simplify.ts';

function simplified(geometry: BufferGeometry, most: number) {
  const welded = weldTriangles(geometry, () => true);
  const positions = restVertices(new Mesh(geometry), welded);
  const triangles = simplify(welded.triangles, positions, most);
  const at = (vertex: number): readonly number[] => [...positions.subarray(vertex * 3, vertex * 3 + 3)];
  return { triangles, at, edges: collectEdges(triangles, welded.vertices.length) };
}

describe('simplifying', () => {
  test('a torus keeps it closed and near its surface', () => {
    const { triangles, at, edges } = simplified(new TorusGeometry(1, 0.3, 60, 160), 2000);
    expect(triangles.length / 3).toBeLessThanOrEqual(2000);
    expect(triangles.length / 3).toBeGreaterThan(1900);
    expect(edges.closed).toBe(true);
    // A torus has as many vertices and faces as edges.
    expect(new Set(triangles).size + triangles.length / 3).toBe(edges.edges.length / 2);
    let farthest = 0;
    for (let t = 0; t < triangles.length; t += 3) {
      const corners = [...triangles.subarray(t, t + 3)].map(at);
      const [x = 0, y = 0, z = 0] = [0, 1, 2].map((axis) => corners.reduce((sum, corner) => sum + (corner[axis] ?? 0) / 3, 0));
      farthest = Math.max(farthest, Math.abs(Math.hypot(Math.hypot(x, y) - 1, z) - 0.3));
    }
    expect(farthest).toBeLessThan(0.02);
  });

  test('a sheet with a hill keeps its border', () => {
    const sheet = new PlaneGeometry(2, 2, 60, 60);
    const { position } = sheet.attributes;
    for (let i = 0; i < (position?.count ?? 0); i++) {
      const [x, y] = [position?.getX(i) ?? 0, position?.getY(i) ?? 0];
      position?.setZ(i, 0.5 * Math.exp(-8 * (x * x + y * y)));
    }
    const { edges, at } = simplified(sheet, 500);
    let length = 0;
    for (let i = 0; i * 2 < edges.edges.length; i++) {
      if ((edges.usesOf[i + 1] ?? 0) - (edges.usesOf[i] ?? 0) !== 1) continue;
      const [a, b] = [at(edges.edges[i * 2] ?? 0), at(edges.edges[i * 2 + 1] ?? 0)];
      length += Math.hypot(...a.map((coordinate, axis) => coordinate - (b[axis] ?? 0)));
    }
    expect(length).toBeCloseTo(8, 1);
  });

  test('parts that hang together nowhere removes the smallest', () => {
    const positions: number[] = [];
    for (let i = 0; i < 100; i++) positions.push(i, 0, 0, i + 0.001 * (i + 1), 0, 0, i, 0.001 * (i + 1), 0);
    const left = simplify(
      Uint32Array.from({ length: 300 }, (_, i) => i),
      Float32Array.from(positions),
      40,
    );
    expect(left).toHaveLength(120);
    expect(Math.min(...left)).toBe(180);
  });
});
