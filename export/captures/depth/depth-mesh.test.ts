import { expect, test } from '@jest/globals';
import type { Pinhole } from '../../../nodes/kit/capture.ts';
import { depthFromMesh } from './depth-from-mesh.ts';
import type { DepthMap } from './depth-map.ts';
import { makeDepthMesh } from './depth-mesh.ts';
import { pointsOfDepthMesh } from './depth-points.ts';
import { panoramaRays, pinholeRays } from './depth-rays.ts';

const SIZE = { widthPx: 640, heightPx: 480 };
const PINHOLE: Pinhole = { ...SIZE, fxPx: 520, fyPx: 520, cxPx: 320, cyPx: 240 };
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const RAYS = pinholeRays(PINHOLE);

/** A room of walls, with a ball 2 m away. `x` is to the right, `y` down, `z` forward; how many of them reach the first surface. */
function hit(x: number, y: number, z: number): number {
  const wall = Math.min(y > 0 ? 1.5 / y : 1.2 / -y, 2.5 / Math.abs(x), (z > 0 ? 5 : 2) / Math.abs(z));
  const a = x * x + y * y + z * z;
  const b = 2 * z;
  const root = b * b - a * (4 - 0.25);
  return root > 0 && b > 0 ? (b - Math.sqrt(root)) / a : wall;
}

const seen: DepthMap = {
  ...SIZE,
  values: Float32Array.from({ length: 640 * 480 }, (_, i) => hit(RAYS.across[i % 640] ?? 0, RAYS.down[Math.floor(i / 640)] ?? 0, 1)),
};

test('shows a depth map with few triangles and small errors, and nothing between near and far things', () => {
  const mesh = makeDepthMesh(seen, RAYS, 1e6);
  expect(mesh.indices.length / 3).toBeLessThan(0.1 * 2 * 639 * 479);
  const drawn = depthFromMesh(pointsOfDepthMesh(mesh, RAYS), PINHOLE, IDENTITY);
  const errors = [...drawn.values]
    .flatMap((depth, i) => (depth > 0 ? Math.abs(depth / (seen.values[i] ?? 0) - 1) : []))
    .sort((a, b) => a - b);
  expect(errors[Math.floor(errors.length * 0.99)]).toBeLessThan(0.01);
  // A stretched triangle would be drawn between the depths of ball and wall.
  expect(errors.at(-1)).toBeLessThan(0.03);
  // Holes are along the outline of the ball only: no cracks. The outermost pixels lie on the rim of the mesh.
  const isInside = (i: number): boolean => i % 640 > 0 && i % 640 < 639 && i > 640 && i < 640 * 479;
  const holes = [...drawn.values.keys()].filter((i) => drawn.values[i] === 0 && isInside(i));
  expect(holes.length).toBeLessThan(1700);
  for (const i of holes) {
    const around = [i - 641, i - 640, i - 639, i - 1, i + 1, i + 639, i + 640, i + 641].map((at) => seen.values[at] ?? 0);
    expect(Math.max(...around) / Math.min(...around)).toBeGreaterThan(1.2);
  }
});

test('leaves out what is unknown, and takes a larger error where a mesh has too many triangles', () => {
  const holey = { ...seen, values: seen.values.map((depth, i) => (i % 640 < 320 ? 0 : depth)) };
  const { places, indices } = makeDepthMesh(holey, RAYS, 1e6);
  expect(places.filter((_, i) => i % 2 === 0).every((column) => column >= 641)).toBe(true);
  expect(indices.length).toBeGreaterThan(0);
  const limit = makeDepthMesh(seen, RAYS, 1e6).indices.length / 3 - 1;
  expect(makeDepthMesh(seen, RAYS, limit).indices.length / 3).toBeLessThanOrEqual(limit);
});

test('closes the seam and the poles of a 360° view', () => {
  const rays = panoramaRays(512, 256);
  const values = Float32Array.from({ length: 512 * 256 }, (_, i) => {
    const [column, row] = [i % 512, Math.floor(i / 512)];
    const level = rays.level[row] ?? 0;
    // Behind the camera, where the seam is, there are only walls.
    return hit((rays.across[column] ?? 0) * level, rays.down[row] ?? 0, (rays.ahead[column] ?? 0) * level);
  });
  const mesh = makeDepthMesh({ widthPx: 512, heightPx: 256, values }, rays, 1e6);
  expect(mesh.indices.length / 3).toBeLessThan(0.1 * 2 * 512 * 255);
  const points = pointsOfDepthMesh(mesh, rays);
  const lens: Pinhole = { widthPx: 200, heightPx: 200, fxPx: 100, fyPx: 100, cxPx: 100, cyPx: 100 };
  // Cameras that look backward, up and down: right, up and backward axes.
  const behind = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1];
  const upward = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1];
  const downward = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1];
  const directions = [
    [behind, (x: number, y: number) => hit(-x, y, -1)],
    [upward, (x: number, y: number) => hit(x, -1, -y)],
    [downward, (x: number, y: number) => hit(x, 1, y)],
  ] as const;
  for (const [pose, truth] of directions) {
    const drawn = depthFromMesh(points, lens, pose);
    drawn.values.forEach((depth, i) => {
      const [x, y] = [((i % 200) + 0.5 - 100) / 100, (Math.floor(i / 200) + 0.5 - 100) / 100];
      if (Math.abs(depth / truth(x, y) - 1) > 0.02) throw new Error(`At ${x}, ${y} the depth is ${depth} instead of ${truth(x, y)}.`);
    });
  }
});
