import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute, Mesh, PlaneGeometry } from 'three';
import { createMeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { type EdgeSegment, findSegments } from './mesh-edges.ts';

function segmentsOf(geometry: BufferGeometry, { bends = false, limit = 10_000 } = {}): readonly EdgeSegment[] | null {
  const shape = createMeshShape(geometry, () => true);
  return findSegments(shape, restVertices(new Mesh(geometry), shape), bends, limit);
}

const edgesOf = (segments: readonly EdgeSegment[] | null) => [...new Set(segments?.map(({ edge }) => edge))];

describe('edges', () => {
  test('of a box are its twelve creases of a right angle, whatever the normals and the triangles of its sides', () => {
    const edges = edgesOf(segmentsOf(new BoxGeometry(1, 2, 3)));
    expect(edges).toHaveLength(12);
    for (const { angle } of edges) expect(angle).toBeCloseTo(Math.PI / 2, 6);
  });

  test('of a sheet are its border, and all edges if it bends', () => {
    const sheet = new PlaneGeometry(1, 1, 2, 2);
    const edges = edgesOf(segmentsOf(sheet));
    expect(edges).toHaveLength(8);
    expect(edges.every(({ d, angle }) => d === -1 && angle === Math.PI)).toBe(true);
    expect(edgesOf(segmentsOf(sheet, { bends: true }))).toHaveLength(16);
  });

  test('that are concave have a negative angle', () => {
    const open = new BufferGeometry();
    // A floor, and a wall that rises from it at a right angle; both are seen from above and before.
    open.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0], 3));
    open.setIndex([0, 2, 1, 3, 5, 4]);
    const inner = edgesOf(segmentsOf(open)).filter(({ d }) => d >= 0);
    expect(inner.map(({ angle }) => angle)).toEqual([expect.closeTo(-Math.PI / 2, 6)]);
  });

  test('are not returned if there are more than the limit', () => {
    expect(segmentsOf(new CylinderGeometry(1, 1, 1, 64), { limit: 100 })).toBeNull();
  });
});

describe('strokes', () => {
  test('of a box end at its corners, and are cut into short segments that follow each other', () => {
    const segments = segmentsOf(new BoxGeometry(1, 2, 3)) ?? [];
    const strokes = edgesOf(segments).map((edge) => segments.filter((segment) => segment.edge === edge));
    expect(strokes.map(([first]) => Math.round(first?.stroke ?? 0)).sort()).toEqual([1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3]);
    for (const parts of strokes) {
      expect(parts.length).toBeGreaterThan(9);
      for (const [i, part] of parts.entries()) expect(part.alongFrom).toBeCloseTo(parts[i - 1]?.alongTo ?? 0, 6);
      expect(parts.at(-1)?.alongTo).toBeCloseTo(parts[0]?.stroke ?? 0, 6);
    }
  });

  test('of a cylinder follow its rims: edges of a stroke meet end to end', () => {
    const segments = segmentsOf(new CylinderGeometry(1, 1, 1, 24)) ?? [];
    const rims = segments.filter(({ stroke }) => stroke > 0);
    const lengths = [...new Set(rims.map(({ stroke }) => stroke.toFixed(3)))];
    // The perimeter of a regular 24-gon.
    expect(lengths).toEqual([(48 * Math.sin(Math.PI / 24)).toFixed(3)]);
    for (const [i, { edge, from, to, alongFrom }] of rims.entries()) {
      const before = rims[i - 1];
      if (!before || alongFrom === 0) continue;
      const endOf = before.to > before.from ? before.edge.b : before.edge.a;
      const startOf = to > from ? edge.a : edge.b;
      if (before.edge !== edge) expect(startOf).toBe(endOf);
    }
  });
});
