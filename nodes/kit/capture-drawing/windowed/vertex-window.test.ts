import { expect, test } from '@jest/globals';
import { vertexNormals } from './vertex-normals.ts';
import { createVertexWindow } from './vertex-window.ts';

test('visits all vertices within its frames from any place, whatever frames take', () => {
  let state = 5;
  const dice = (): number => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  for (let round = 0; round < 300; round++) {
    const count = 1 + Math.floor(400 * dice() ** 2);
    const frames = 1 + Math.floor(12 * dice());
    const window = createVertexWindow(count, frames);
    for (let i = Math.floor(20 * dice()); i > 0; i--) {
      window.advance(0.03 * dice(), false);
      if (dice() < 0.7) window.restart();
    }
    window.restart();
    const visits = new Uint8Array(count);
    for (let frame = 0; frame < frames; frame++) {
      window.advance(0.03 * dice(), false);
      for (let i = 0; i < window.count; i++) visits[window.first + i] = (visits[window.first + i] ?? 0) + 1;
    }
    expect({ count, frames, visits: [...new Set(visits)] }).toEqual({ count, frames, visits: [1] });
    expect([window.advance(0.01, false), window.count]).toEqual([false, 0]);
  }
});

test('grows while frames come in time, and shrinks when they come late', () => {
  const window = createVertexWindow(10_000, 51);
  const sizes = [0.016, 0.016, 0.016, 0.016, 0.04, 0.04, 0.04, 0.04].map((deltaS) => {
    window.restart();
    window.advance(deltaS, false);
    return window.count;
  });
  expect(sizes).toEqual([250, 313, 392, 490, 343, 241, 200, 200]);
  window.restart();
  window.advance(0.04, true);
  expect([window.first, window.count]).toEqual([0, 10_000]);
});

test('normals of vertices are those of their triangles, the larger ones counting more', () => {
  // Two triangles along x and y, and one in the plane z = 0, at one vertex.
  const positions = Float32Array.of(0, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0, 0, 3, 0);
  const normals = vertexNormals({ positions, indices: Uint32Array.of(0, 1, 2, 0, 3, 4) });
  expect([...normals.subarray(4, 8)]).toEqual([127, 0, 0, 0]);
  expect([...normals.subarray(12, 16)]).toEqual([0, 0, 127, 0]);
  expect([...normals.subarray(0, 4)]).toEqual([Math.round(127 / Math.hypot(1, 9)), 0, Math.round((9 * 127) / Math.hypot(1, 9)), 0]);
});
