import { expect, test } from '@jest/globals';
import type { Pinhole } from '../../../nodes/kit/capture.ts';
import { type CameraPlaces, cameraPoses } from '../acquire/camera-places.ts';
import { depthSeen } from './depth-from-mesh.ts';
import type { DepthMap } from './depth-map.ts';
import { makeDepthMesh } from './depth-mesh.ts';
import { raysOf } from './depth-rays.ts';
import { createDepthFusion } from './fuse-depth-meshes.ts';

const SIDE = 64;
const CAMERA: Pinhole = { widthPx: SIDE, heightPx: SIDE, fxPx: 73, fyPx: 73, cxPx: SIDE / 2, cyPx: SIDE / 2 };
const AROUND: Pinhole = {
  widthPx: 128,
  heightPx: 64,
  fxPx: 128 / 2 / Math.PI,
  fyPx: 64 / Math.PI,
  cxPx: 64,
  cyPx: 32,
  projection: 'equirectangular',
};
const PLACES: CameraPlaces = {
  shape: 'outside-in',
  counts: [8, 1, 1],
  centerM: [0, 0, 0],
  extentM: [2, 2, 2],
  yawRad: 0,
  elevationRad: [-Math.PI / 2, Math.PI / 2],
};
const RADIUS = 0.3;

/** What a camera sees of a ball at the origin, whose depth is the root of a quadratic equation. */
function ballSeen(camera: Pinhole, m: readonly number[]): DepthMap {
  const values = new Float32Array(camera.widthPx * camera.heightPx);
  const { across, ahead, level, down } = raysOf(camera);
  values.forEach((_, i) => {
    const [column, row] = [i % camera.widthPx, Math.floor(i / camera.widthPx)];
    const local = [(across[column] ?? 0) * (level[row] ?? 0), -(down[row] ?? 0), -(ahead[column] ?? 0) * (level[row] ?? 0)];
    const ray = [0, 1, 2].map((k) => local.reduce((sum, x, axis) => sum + x * (m[4 * axis + k] ?? 0), 0));
    const [a, b, c] = [0, 1, 2].reduce(
      ([a, b, c], k) => {
        const [r, o] = [ray[k] ?? 0, m[12 + k] ?? 0];
        return [a + r * r, b + r * o, c + o * o] as const;
      },
      [0, 0, -RADIUS * RADIUS] as readonly [number, number, number],
    );
    const root = b * b - a * c;
    // From inside, the ball is seen beyond the camera.
    values[i] = root < 0 ? 0 : (c < 0 ? -b + Math.sqrt(root) : -b - Math.sqrt(root)) / a;
  });
  return { widthPx: camera.widthPx, heightPx: camera.heightPx, values };
}

test.each([
  ['photographs around a ball', CAMERA, PLACES, 0.6],
  ['360° photographs in a ball', AROUND, { ...PLACES, counts: [4, 1, 1], extentM: [0.2, 0.2, 0.2] }, 0.5],
] as const)('%s become one mesh without holes, and what several show is in it about once', (_, camera, places, mostOfAll) => {
  const fusion = createDepthFusion();
  let all = 0;
  const poses = cameraPoses(places, camera.projection !== undefined);
  for (const worldFromCamera of poses) {
    const map = ballSeen(camera, worldFromCamera);
    const made = makeDepthMesh(map, raysOf(camera), 100_000);
    all += made.indices.length / 3;
    fusion.add({ made, map, camera, worldFromCamera });
  }
  const mesh = fusion.mesh();
  expect(mesh.indices.length / 3).toBeLessThan(mostOfAll * all);
  expect(Math.max(...mesh.indices)).toBeLessThan(mesh.positions.length / 3);
  for (const pose of poses) {
    const truth = ballSeen(camera, pose);
    const seen = depthSeen(mesh, camera, pose);
    const { widthPx } = camera;
    const isKnown = (i: number): boolean => (truth.values[i] ?? 0) > 0;
    let worst = 0;
    truth.values.forEach((depth, i) => {
      // Pixels at the outline have no triangle of their own.
      const around = [0, -2, 2, -2 * widthPx, 2 * widthPx];
      if (!around.every((step) => isKnown(i + step))) return;
      worst = Math.max(worst, Math.abs((seen.values[i] ?? 0) / depth - 1));
    });
    // Nowhere is nothing, or the far side of the ball, seen through a hole.
    expect(worst).toBeLessThan(0.03);
  }
});
