import { describe, expect, test } from '@jest/globals';
import { createMatrix } from '../matrix.ts';
import type { Intrinsics } from '../session-format.ts';
import { type Crop, setCoverCrop, setCropProjection, setUvFromViewUv } from './camera-crop.ts';

/** A camera whose axis misses the middle of its 640 × 480 picture. */
const CAMERA: Intrinsics = { fxPx: 500, fyPx: 520, cxPx: 300, cyPx: 260 };

function crop(viewWidthPx: number, viewHeightPx: number): Crop {
  const out = { x0: 0, y0: 0, x1: 0, y1: 0 };
  setCoverCrop(out, 640, 480, viewWidthPx, viewHeightPx);
  return out;
}

/** Pixel of the picture, y down, where the camera sees a point of its space (x right, y up, -z forward). */
function project(camera: Intrinsics, [x, y, z]: readonly [number, number, number]): [number, number] {
  return [camera.cxPx + (camera.fxPx * x) / -z, camera.cyPx + (camera.fyPx * -y) / -z];
}

function viewUv(clipFromView: Float32Array, [x, y, z]: readonly [number, number, number]): [number, number] {
  const row = (r: number): number =>
    (clipFromView[r] ?? 0) * x + (clipFromView[r + 4] ?? 0) * y + (clipFromView[r + 8] ?? 0) * z + (clipFromView[r + 12] ?? 0);
  return [0.5 + (0.5 * row(0)) / row(3), 0.5 + (0.5 * row(1)) / row(3)];
}

const POINTS = [
  [0, 0, -1],
  [0.3, -0.2, -2],
  [-0.5, 0.4, -3.5],
] as const;

describe.each([
  ['as the picture', 640, 480],
  ['wide', 1600, 400],
  ['upright', 300, 600],
])('a view %s', (_name, widthPx, heightPx) => {
  const area = crop(widthPx, heightPx);

  test('shows the middle of the picture, all of one side', () => {
    expect((area.x1 - area.x0) / (area.y1 - area.y0)).toBeCloseTo(widthPx / heightPx, 9);
    expect(Math.max((area.x1 - area.x0) / 640, (area.y1 - area.y0) / 480)).toBeCloseTo(1, 9);
    expect([(area.x0 + area.x1) / 2, (area.y0 + area.y1) / 2]).toEqual([320, 240]);
  });

  test('projects points to where the picture shows them', () => {
    const clipFromView = createMatrix();
    setCropProjection(clipFromView, area, CAMERA, 0.1, 100);
    for (const point of POINTS) {
      const [u, v] = viewUv(clipFromView, point);
      const [px, py] = project(CAMERA, point);
      expect(area.x0 + u * (area.x1 - area.x0)).toBeCloseTo(px, 3);
      expect(area.y1 - v * (area.y1 - area.y0)).toBeCloseTo(py, 3);
    }
  });

  test('finds the same points in the picture of another camera at the same place', () => {
    const other: Intrinsics = { fxPx: 210, fyPx: 190, cxPx: 150, cyPx: 130 };
    const clipFromView = createMatrix();
    setCropProjection(clipFromView, area, CAMERA, 0.1, 100);
    const uv = new Float32Array(9);
    setUvFromViewUv(uv, area, CAMERA, other, 320, 240);
    for (const point of POINTS) {
      const [u, v] = viewUv(clipFromView, point);
      const [px, py] = project(other, point);
      expect(((uv[0] ?? 0) * u + (uv[6] ?? 0)) * 320).toBeCloseTo(px, 3);
      // The first row of the texture is the picture's top.
      expect(((uv[4] ?? 0) * v + (uv[7] ?? 0)) * 240).toBeCloseTo(py, 3);
    }
  });
});

test('near and far lie on the faces of clip space', () => {
  const m = createMatrix();
  setCropProjection(m, crop(640, 480), CAMERA, 0.1, 100);
  const depth = (meters: number): number => ((m[10] ?? 0) * -meters + (m[14] ?? 0)) / meters;
  expect(depth(0.1)).toBeCloseTo(-1, 4);
  expect(depth(100)).toBeCloseTo(1, 4);
});
