import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, type BufferGeometry, Mesh, PlaneGeometry, SphereGeometry } from 'three';
import { createMeshShape } from '../../volumes/mesh-shape.ts';
import { restVertices } from '../../volumes/pose-vertices.ts';
import { findSegments } from './mesh-edges.ts';

/** The room of all segments, from least to most. */
function roomsOf(geometry: BufferGeometry): readonly number[] {
  const shape = createMeshShape(geometry, () => true);
  const segments = findSegments(shape, restVertices(new Mesh(geometry), shape), false, 100_000) ?? [];
  return segments.flatMap(({ roomFrom, roomTo }) => [roomFrom, roomTo]).sort((a, b) => a - b);
}

const median = (values: readonly number[]): number => values[values.length >> 1] ?? Number.NaN;

/** A sheet of 1 m that is folded to ridges. */
function ridges(count: number): BufferGeometry {
  const sheet = new PlaneGeometry(1, 1, 2 * count, 20);
  const { position } = sheet.attributes;
  for (let i = 0; i < (position?.count ?? 0); i++) position?.setZ(i, (i % (2 * count + 1)) % 2 === 0 ? 0 : 0.25 / count);
  return sheet;
}

describe('room for lines', () => {
  test.each([16, 32])('between %d ridges is about their distance', (count) => {
    const room = median(roomsOf(ridges(count))) * count;
    expect(room).toBeGreaterThan(0.5);
    expect(room).toBeLessThan(2);
  });

  test('is as large as a box or a ball at its edges, whatever its triangles', () => {
    for (const shape of [new BoxGeometry(1, 1, 1), new BoxGeometry(1, 1, 1, 9, 9, 9), new SphereGeometry(0.5, 40, 30)])
      expect(roomsOf(shape)[0]).toBeGreaterThan(0.2);
  });
});
