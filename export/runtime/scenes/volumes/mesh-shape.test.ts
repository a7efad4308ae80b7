import { expect, test } from '@jest/globals';
import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  PlaneGeometry,
  SphereGeometry,
  Uint16BufferAttribute,
} from 'three';
import { createMeshShape } from './mesh-shape.ts';

const facts = (geometry: BufferGeometry, isUsed: (i: number) => boolean = () => true) => {
  const { vertices, triangles, edges, closed } = createMeshShape(geometry, isUsed);
  return { vertices: vertices.length, triangles: triangles.length / 3, edges: edges.length / 2, closed };
};

test('closes a box whose faces have corners of their own', () => {
  expect(facts(new BoxGeometry())).toEqual({ vertices: 8, triangles: 12, edges: 18, closed: true });
});

test('closes the seam of a ball, which is computed twice, and drops its triangles of no size', () => {
  // 16 meridians, 7 rings between the poles: Euler's V - E + F = 2.
  expect(facts(new SphereGeometry(1, 16, 8))).toEqual({ vertices: 114, triangles: 224, edges: 336, closed: true });
});

test('sees the borders of sheets and tubes', () => {
  expect(facts(new PlaneGeometry())).toEqual({ vertices: 4, triangles: 2, edges: 5, closed: false });
  expect(facts(new CylinderGeometry(1, 1, 1, 8, 1, true)).closed).toBe(false);
});

test('leaves out what no used material draws', () => {
  expect(facts(new BoxGeometry(), (i) => i !== 2)).toEqual({ vertices: 8, triangles: 10, edges: 17, closed: false });
});

test('is not closed where triangles disagree on which way is out', () => {
  const box = new BoxGeometry();
  const index = box.index?.array;
  if (index) [index[0], index[1]] = [index[1] ?? 0, index[0] ?? 0];
  expect(facts(box).closed).toBe(false);
});

test('keeps apart what stands in one place and follows other bones', () => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0, 0], 3));
  const bones = (all: readonly number[]): BufferGeometry =>
    geometry
      .clone()
      .setAttribute(
        'skinIndex',
        new Uint16BufferAttribute(
          all.flatMap((bone) => [bone, 0, 0, 0]),
          4,
        ),
      )
      .setAttribute(
        'skinWeight',
        new Float32BufferAttribute(
          all.flatMap(() => [1, 0, 0, 0]),
          4,
        ),
      );
  expect(facts(bones([0, 0, 0, 0, 0, 0])).vertices).toBe(4);
  expect(facts(bones([0, 0, 0, 1, 1, 1])).vertices).toBe(6);
});
