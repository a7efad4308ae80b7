import { expect, test } from '@jest/globals';
import { poseFault } from '../../../nodes/kit/capture.ts';
import { readPfm } from '../depth/read-depth.ts';
import { writePfm } from '../depth/write-pfm.ts';
import { project } from '../lens.ts';
import { readTransforms } from '../transforms-json.ts';
import { type CameraPlaces, cameraPoses } from './camera-places.ts';
import { FACE_POSES, type Face, faceSidePx, faceTangent, panoramaFromFaces } from './cube-to-panorama.ts';
import { fillEmpty } from './fill-empty.ts';
import { transformsText } from './write-transforms.ts';

const SPHERE: CameraPlaces = {
  shape: 'outside-in',
  counts: [42, 1, 1],
  centerM: [0, 0.4, -1],
  extentM: [2, 2, 2],
  yawRad: 0,
  elevationRad: [-Math.PI / 2, Math.PI / 2],
};
const at = (pose: readonly number[], column: number): readonly number[] => pose.slice(4 * column, 4 * column + 3);
const dot = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);
const from = (center: readonly number[], pose: readonly number[]) => at(pose, 3).map((x, i) => x - (center[i] ?? 0));

test('cameras on a sphere look at its center, or away from it, and are evenly spread', () => {
  const inward = cameraPoses(SPHERE, false);
  expect(inward).toHaveLength(42);
  for (const pose of inward) {
    expect(poseFault(pose)).toBeNull();
    expect(Math.hypot(...from(SPHERE.centerM, pose))).toBeCloseTo(1);
    // The z axis of a camera points back.
    expect(dot(at(pose, 2), from(SPHERE.centerM, pose))).toBeCloseTo(1);
    expect(pose[5]).toBeGreaterThanOrEqual(0);
  }
  for (const [i, pose] of cameraPoses({ ...SPHERE, shape: 'inside-out' }, false).entries()) {
    expect(at(pose, 3)).toEqual(at(inward[i] ?? [], 3));
    expect(dot(at(pose, 2), from(SPHERE.centerM, pose))).toBeCloseTo(-1);
  }
  // Of 42 caps of equal area, which cannot cover a sphere without gaps, each has an angular diameter of 35.5°.
  const nearest = inward.map((a) =>
    Math.min(...inward.filter((b) => b !== a).map((b) => Math.acos(dot(from(SPHERE.centerM, a), from(SPHERE.centerM, b))))),
  );
  expect(Math.min(...nearest)).toBeGreaterThan(0.7 * 2 * Math.acos(1 - 2 / 42));
});

test('cameras of an ellipsoid lie on it, within the elevations', () => {
  const elevationRad = [0.2, 1] as const;
  const poses = cameraPoses({ ...SPHERE, extentM: [4, 2, 1], elevationRad }, false);
  for (const pose of poses) {
    const [x = 0, y = 0, z = 0] = from(SPHERE.centerM, pose);
    expect((x / 2) ** 2 + y ** 2 + (z / 0.5) ** 2).toBeCloseTo(1);
    expect(y).toBeGreaterThan(Math.sin(0.2));
    expect(y).toBeLessThan(Math.sin(1));
    expect(poseFault(pose)).toBeNull();
  }
  const [straightDown = []] = cameraPoses({ ...SPHERE, counts: [1, 1, 1], elevationRad: [Math.PI / 2, Math.PI / 2] }, false);
  expect(poseFault(straightDown)).toBeNull();
  expect(at(straightDown, 2)).toEqual([expect.closeTo(0), 1, expect.closeTo(0)]);
});

test('cameras of a grid fill its size with both ends, and look the same way', () => {
  const poses = cameraPoses({ ...SPHERE, shape: 'grid', counts: [3, 1, 2], yawRad: Math.PI / 2 }, false);
  expect(poses.map((pose) => at(pose, 3))).toEqual([
    [-1, 0.4, -2],
    [0, 0.4, -2],
    [1, 0.4, -2],
    [-1, 0.4, 0],
    [0, 0.4, 0],
    [1, 0.4, 0],
  ]);
  // A quarter turn to the left looks along −x.
  for (const pose of poses) expect(at(pose, 2).map((x) => Math.round(x * 1e9) / 1e9)).toEqual([1, 0, 0]);
  for (const pose of cameraPoses({ ...SPHERE, yawRad: 0 }, true)) expect(at(pose, 2)).toEqual([0, 0, 1]);
});

test('transforms.json is read as it was written', () => {
  const poses = cameraPoses(SPHERE, false);
  const views = poses.map((worldFromCamera, i) => ({ file: `images/${i}.png`, depthFile: `depth/${i}.pfm`, worldFromCamera }));
  const camera = { projection: 'perspective', widthPx: 640, heightPx: 480, fovYRad: Math.PI / 2 } as const;
  const read = readTransforms(new TextEncoder().encode(transformsText(camera, views)));
  expect(read.views.map(({ name, depthName }) => [name, depthName])).toEqual(views.map(({ file, depthFile }) => [file, depthFile]));
  for (const [i, view] of read.views.entries()) {
    // JSON has no -0.
    expect(view.worldFromCamera.map((x) => x + 0)).toEqual(poses[i]?.map((x) => x + 0));
    const place = new Float64Array(2);
    // The lower edge is 45° below the axis.
    project(view.lens(640, 480), 0, 1, place);
    expect([...place]).toEqual([320, expect.closeTo(480)]);
  }
  const around = transformsText({ projection: 'equirectangular', widthPx: 64, heightPx: 32 }, views);
  expect(readTransforms(new TextEncoder().encode(around)).views[0]?.lens(64, 32).projection).toBe('equirectangular');
});

test('depth survives a PFM file', () => {
  const map = { widthPx: 3, heightPx: 2, values: Float32Array.of(0, 0.1, 1 / 3, 12, 100, 2) };
  expect(readPfm(writePfm(map), 'a')).toEqual(map);
});

test('a 360° photograph of a box has the distances and directions of the box', () => {
  const widthPx = 256;
  const side = faceSidePx(widthPx);
  const tangent = faceTangent(side);
  /** What a camera in the middle of a cube of 2 m sees: the direction as color, and the depth along its axis, which is 1 m for all faces. */
  const faces = FACE_POSES.map((m): Face => {
    const pixels = new Uint8Array(4 * side * side).fill(255);
    for (let row = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const [x, y] = [(2 * (column + 0.5)) / side - 1, 1 - (2 * (row + 0.5)) / side];
        const local = [x * tangent, y * tangent, -1];
        const length = Math.hypot(...local);
        const world = [0, 1, 2].map((i) => local.reduce((sum, value, k) => sum + value * (m[4 * k + i] ?? 0), 0) / length);
        world.forEach((value, c) => {
          pixels[4 * (row * side + column) + c] = Math.round(127.5 + 127.5 * value);
        });
      }
    }
    return { widthPx: side, heightPx: side, pixels, meters: new Float32Array(side * side).fill(1) };
  });
  const { pixels, meters, heightPx } = panoramaFromFaces(faces, widthPx);
  let worstColor = 0;
  let worstMeters = 0;
  for (let row = 0; row < heightPx; row++) {
    for (let column = 0; column < widthPx; column++) {
      const latitude = Math.PI * (0.5 - (row + 0.5) / heightPx);
      const longitude = 2 * Math.PI * ((column + 0.5) / widthPx - 0.5);
      const ray = [Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude), -Math.cos(latitude) * Math.cos(longitude)];
      const i = row * widthPx + column;
      ray.forEach((value, c) => {
        worstColor = Math.max(worstColor, Math.abs((pixels[4 * i + c] ?? 0) - (127.5 + 127.5 * value)));
      });
      // The distance to the wall of a cube is 1 over the largest part of the direction.
      worstMeters = Math.max(worstMeters, Math.abs((meters[i] ?? 0) - 1 / Math.max(...ray.map(Math.abs))));
    }
  }
  expect(worstColor).toBeLessThan(1.5);
  expect(worstMeters).toBeLessThan(1e-5);
});

test('transparent pixels continue the colors beside them, and keep their alpha', () => {
  // Half-covered red, then nothing, then blue.
  const pixels = Uint8Array.of(100, 0, 0, 128, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 200, 255);
  expect([...fillEmpty(pixels, 4, 1)]).toEqual([199, 0, 0, 128, 199, 0, 0, 0, 0, 0, 200, 0, 0, 0, 200, 255]);
  expect([...fillEmpty(new Uint8Array(4 * 9), 3, 3)]).toEqual([...new Uint8Array(36)]);
  const opaque = Uint8Array.of(1, 2, 3, 255);
  expect(fillEmpty(opaque, 1, 1)).toEqual(opaque);
});
