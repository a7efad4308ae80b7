import { readFile } from 'node:fs/promises';
import { NodeIO } from '@gltf-transform/core';
import { KHRMeshQuantization } from '@gltf-transform/extensions';
import { describe, expect, test } from '@jest/globals';
import type { BufferGeometry } from 'three';
import { blend, carve, ellipsoid, limb } from './distance.ts';
import { meshOf } from './mesh-of.ts';

const LOW = [-1, -1, -1] as const;
const HIGH = [1, 1, 1] as const;

/** How often each edge occurs in each direction: once in each if the mesh is closed and its triangles agree about the outside. */
function openEdges(geometry: BufferGeometry): number {
  const index = [...(geometry.getIndex()?.array ?? [])];
  const counts = new Map<string, number>();
  for (let i = 0; i < index.length; i += 3) {
    for (const [a, b] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ] as const) {
      const [from, to] = [index[i + a] ?? 0, index[i + b] ?? 0];
      const key = `${Math.min(from, to)},${Math.max(from, to)}`;
      counts.set(key, (counts.get(key) ?? 0) + (from < to ? 1 : -1));
    }
  }
  return [...counts.values()].filter((sum) => sum !== 0).length;
}

/** Volume by the divergence theorem: positive if triangles face outwards. */
function volumeOf(geometry: BufferGeometry): number {
  const at = geometry.getAttribute('position').array;
  const index = [...(geometry.getIndex()?.array ?? [])];
  let sum = 0;
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => at[(index[i + k] ?? 0) * 3 + axis] ?? 0));
    const [ax = 0, ay = 0, az = 0] = a ?? [];
    const [bx = 0, by = 0, bz = 0] = b ?? [];
    const [cx = 0, cy = 0, cz = 0] = c ?? [];
    sum += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
  }
  return sum;
}

describe('a mesh of a signed distance', () => {
  const ball = meshOf(ellipsoid([0, 0, 0], [0.7, 0.7, 0.7]), LOW, HIGH, 0.05);

  test('of a ball has the volume of the ball, all vertices on it, and normals from its center', () => {
    expect(openEdges(ball)).toBe(0);
    expect(volumeOf(ball) / ((4 / 3) * Math.PI * 0.7 ** 3)).toBeCloseTo(1, 2);
    const [at, normal] = [ball.getAttribute('position').array, ball.getAttribute('normal').array];
    for (let i = 0; i < at.length; i += 3) {
      const radius = Math.hypot(at[i] ?? 0, at[i + 1] ?? 0, at[i + 2] ?? 0);
      expect(radius).toBeCloseTo(0.7, 4);
      for (let axis = 0; axis < 3; axis++) expect(normal[i + axis]).toBeCloseTo((at[i + axis] ?? 0) / radius, 3);
    }
  });

  test('is closed where parts blend and are carved', () => {
    const solid = carve(
      0.05,
      blend(
        0.2,
        ellipsoid([0, 0, 0], [0.5, 0.3, 0.4]),
        limb([
          [0, 0, 0, 0.1],
          [0.4, 0.6, 0.2, 0.06],
        ]),
      ),
      ellipsoid([-0.4, 0, 0], [0.2, 0.1, 0.1]),
    );
    const mesh = meshOf(solid, LOW, HIGH, 0.04);
    expect(openEdges(mesh)).toBe(0);
    expect(volumeOf(mesh)).toBeGreaterThan(0.2);
  });

  test('is refused where the solid does not fit its box, because the mesh would have a hole', () => {
    expect(() => meshOf(ellipsoid([0.5, 0, 0], [0.7, 0.7, 0.7]), LOW, HIGH, 0.1)).toThrow('reaches the border');
  });
});

/** Whether they are what the script makes takes minutes to compute here. */
test('the elephants of the examples are the same model of some 32,000 triangles', async () => {
  const [first, ...others] = await Promise.all(
    ['pen-strokes', 'built-of-bricks', 'gooch-tones', 'sketchy-shadow'].map((folder) => readFile(`examples/${folder}/assets/elephant.glb`)),
  );
  for (const other of others) expect(other.equals(first ?? Buffer.of())).toBe(true);
  const doc = await new NodeIO().registerExtensions([KHRMeshQuantization]).readBinary(first ?? Buffer.of());
  const meshes = doc.getRoot().listMeshes();
  expect(meshes.map((mesh) => mesh.getName())).toEqual(['body', 'tusk.left', 'eye.left', 'tusk.right', 'eye.right']);
  const triangles = meshes.flatMap((mesh) => mesh.listPrimitives()).map((part) => (part.getIndices()?.getCount() ?? 0) / 3);
  expect(triangles.reduce((sum, count) => sum + count, 0)).toBeGreaterThan(28_000);
  expect(triangles.reduce((sum, count) => sum + count, 0)).toBeLessThan(36_000);
});
