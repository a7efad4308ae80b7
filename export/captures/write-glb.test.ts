import { NodeIO } from '@gltf-transform/core';
import { expect, test } from '@jest/globals';
import { meshAsGlb, weldMesh } from './write-glb.ts';

/** A box of 12 triangles, each with three vertices of its own. */
function box() {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, (i >> 2) & 1]);
  const sides = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5];
  return {
    positions: Float32Array.from(sides.flatMap((corner) => corners[corner] ?? [])),
    indices: Uint32Array.from(sides, (_, i) => i),
  };
}

test('vertices at the same place become one', () => {
  const { positions, indices } = weldMesh(box());
  expect([positions.length / 3, indices.length / 3]).toEqual([8, 12]);
});

test('another reader finds the triangles, with hard edges where a box has them', async () => {
  const document = await new NodeIO().readBinary(meshAsGlb(weldMesh(box())));
  const [primitive] = document.getRoot().listMeshes()[0]?.listPrimitives() ?? [];
  const [position, normal] = ['POSITION', 'NORMAL'].map((name) => primitive?.getAttribute(name));
  expect(position?.getCount()).toBe(24);
  expect([position?.getMin([]), position?.getMax([])]).toEqual([
    [0, 0, 0],
    [1, 1, 1],
  ]);
  expect(primitive?.getIndices()?.getCount()).toBe(36);
  for (let i = 0; i < 24; i++) {
    const [at, to] = [position?.getElement(i, []) ?? [], normal?.getElement(i, []) ?? []];
    // A normal of a box is along an axis, and points outward.
    const axis = to.findIndex((value) => Math.abs(value) === 1);
    expect([axis >= 0, to[axis]]).toEqual([true, (at[axis] ?? 0) * 2 - 1]);
  }
});

test('a flat bend is shaded smoothly', async () => {
  const bend = { positions: Float32Array.of(0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0.2, 0), indices: Uint32Array.of(0, 1, 2, 0, 3, 1) };
  const document = await new NodeIO().readBinary(meshAsGlb(bend));
  const normal = document.getRoot().listMeshes()[0]?.listPrimitives()[0]?.getAttribute('NORMAL');
  expect(normal?.getCount()).toBe(4);
  const [x = 0, y = 0, z = 0] = normal?.getElement(0, []) ?? [];
  expect([x > 0.05, y > 0.9, Math.abs(z) < 1e-6, Math.hypot(x, y, z)]).toEqual([true, true, true, expect.closeTo(1, 5)]);
});
