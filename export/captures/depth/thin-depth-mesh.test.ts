import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import type { Pinhole } from '../../../nodes/kit/capture.ts';
import { describeWithData } from '../../../tests/support/shared-data.ts';
import { depthSeen } from './depth-from-mesh.ts';
import { type DepthMap, depthForPinhole, isKnown, scaledPinhole } from './depth-map.ts';
import { type DepthMesh, makeDepthMesh } from './depth-mesh.ts';
import { pointsOfDepthMesh } from './depth-points.ts';
import { raysOf } from './depth-rays.ts';
import { thinDepthMesh } from './thin-depth-mesh.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const ROOM: Pinhole = { widthPx: 640, heightPx: 480, fxPx: 525, fyPx: 525, cxPx: 320, cyPx: 240 };

function meshesOf(map: DepthMap, camera: Pinhole): { readonly all: DepthMesh; readonly thin: DepthMesh } {
  const all = makeDepthMesh(map, raysOf(camera), Number.POSITIVE_INFINITY);
  return { all, thin: thinDepthMesh(all, map, raysOf(camera)) };
}

const drawn = (mesh: DepthMesh, camera: Pinhole): DepthMap => depthSeen(pointsOfDepthMesh(mesh, raysOf(camera)), camera, IDENTITY);

/** The relative error of depth of which 99 % of the pixels that a mesh covers have less, and the part of the known pixels that it leaves empty. */
function quality(mesh: DepthMesh, map: DepthMap, camera: Pinhole): { readonly error: number; readonly empty: number } {
  const { values } = drawn(mesh, camera);
  const errors = new Float32Array(values.length);
  let [known, covered] = [0, 0];
  map.values.forEach((depth, i) => {
    if (!isKnown(depth)) return;
    known++;
    if ((values[i] ?? 0) > 0) errors[covered++] = Math.abs((values[i] ?? 0) / depth - 1);
  });
  const sorted = errors.subarray(0, covered).sort();
  return { error: sorted[Math.floor(0.99 * covered)] ?? Number.NaN, empty: 1 - covered / known };
}

/** Triangles as a part of two per square of pixels. */
function share({ indices }: DepthMesh, { widthPx, heightPx, projection }: Pinhole): number {
  return indices.length / 3 / (2 * (widthPx - (projection ? 0 : 1)) * (heightPx - 1));
}

async function readDepth(path: string): Promise<DepthMap> {
  const { width, height, data } = decode(await readFile(path));
  return { widthPx: width, heightPx: height, values: Float32Array.from(data).map((mm) => mm / 1000) };
}

function expectThin(map: DepthMap, camera: Pinhole, mostShare: number): void {
  const { all, thin } = meshesOf(map, camera);
  expect(share(thin, camera)).toBeLessThan(mostShare);
  const [before, after] = [quality(all, map, camera), quality(thin, map, camera)];
  expect(after.error).toBeLessThan(Math.max(0.005, before.error + 0.001));
  expect(after.empty).toBeLessThanOrEqual(before.empty);
}

describeWithData('depth of a real room', 'captures/icl-livingroom/depth', (folder) => {
  test.each([1, 0.5])('has less than 3 %% of the triangles of all pixels, and an error below 0.5 %%, at %d of its size', async (factor) => {
    const camera = scaledPinhole(ROOM, factor);
    const lens = { ...ROOM, projection: 'perspective', radial: [], tangential: [0, 0] } as const;
    for (const name of (await readdir(folder)).sort().filter((_, i) => i % 9 === 8)) {
      expectThin(depthForPinhole(await readDepth(join(folder, name)), lens, camera, 'z', 1), camera, 0.03);
    }
  });
});

describeWithData('360° depth of a gallery', 'panoramas/rgbd360', (folder) => {
  test('has less than 5 % of the triangles of all pixels at a quarter of its size', async () => {
    const whole = await readDepth(join(folder, 'vr-gallery_depth_mm.png'));
    const [widthPx, heightPx] = [whole.widthPx / 4, whole.heightPx / 4];
    const values = Float32Array.from({ length: widthPx * heightPx }, (_, i) => {
      return whole.values[4 * Math.floor(i / widthPx) * whole.widthPx + 4 * (i % widthPx)] ?? 0;
    });
    const perRadian = widthPx / 2 / Math.PI;
    const size = { widthPx, heightPx, fxPx: perRadian, fyPx: perRadian, cxPx: widthPx / 2, cyPx: heightPx / 2 };
    expectThin({ widthPx, heightPx, values }, { ...size, projection: 'equirectangular' }, 0.05);
  });
});

/** A square of a wall 2 m away, before another wall; the sides of the square have a slope of 1 : 3. */
const CAMERA: Pinhole = { widthPx: 48, heightPx: 48, fxPx: 48, fyPx: 48, cxPx: 24, cyPx: 24 };
const isNear = (column: number, row: number): boolean => {
  const [x, y] = [column - 23.5, row - 23.5];
  return Math.abs(3 * x + y) < 45 && Math.abs(3 * y - x) < 45;
};
const WALLS: DepthMap = {
  widthPx: 48,
  heightPx: 48,
  values: Float32Array.from({ length: 48 * 48 }, (_, i) => (isNear(i % 48, Math.floor(i / 48)) ? 2 : 3)),
};

test('outlines of a wall become lines, and nothing is between it and the wall behind it', () => {
  const { all, thin } = meshesOf(WALLS, CAMERA);
  expect(thin.indices.length).toBeLessThan(0.35 * all.indices.length);
  const [before, after] = [drawn(all, CAMERA), drawn(thin, CAMERA)];
  after.values.forEach((depth, i) => {
    const truth = WALLS.values[i] ?? 0;
    // An edge may pass through the center of a pixel.
    expect(depth === 0 || Math.abs(depth / truth - 1) < 1e-5).toBe(true);
    if (before.values[i] !== 0) expect(depth).toBeGreaterThan(0);
  });
  // Each triangle has one wall, is clockwise, and they cover no place twice.
  let area = 0;
  for (let i = 0; i < thin.indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => thin.indices[i + corner] ?? 0) as [number, number, number];
    expect(new Set([a, b, c].map((vertex) => thin.depths[vertex])).size).toBe(1);
    const at = (vertex: number): readonly [number, number] => [thin.places[2 * vertex] ?? 0, thin.places[2 * vertex + 1] ?? 0];
    const [[ax, ay], [bx, by], [cx, cy]] = [at(a), at(b), at(c)];
    const twice = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 4;
    expect(twice).toBeGreaterThan(0);
    area += twice / 2;
  }
  expect(area).toBeLessThan(47 * 47);
  expect(area).toBeGreaterThan(0.9 * 47 * 47);
});

test('a surface that is not flat keeps the vertices that it needs', () => {
  const values = WALLS.values.map((_, i) => 2 + 0.2 * Math.sin((i % 48) / 4));
  const { all, thin } = meshesOf({ ...WALLS, values }, CAMERA);
  expect(thin.indices.length).toBeLessThan(0.6 * all.indices.length);
  const { values: shown } = drawn(thin, CAMERA);
  const inner = [...values.keys()].filter((i) => i % 48 > 0 && i % 48 < 47 && i >= 48 && i < 47 * 48);
  for (const i of inner) expect(Math.abs((shown[i] ?? 0) / (values[i] ?? 0) - 1)).toBeLessThan(1.05 * thin.tolerance);
});
