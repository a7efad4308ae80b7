import { expect, test } from '@jest/globals';
import type { CaptureMesh, Pinhole } from '../../nodes/kit/capture.ts';
import { vertexNormals } from '../../nodes/kit/capture-drawing/windowed/vertex-normals.ts';
import { paperViews, paperWeights } from './paper-weights.ts';

const PINHOLE: Pinhole = { widthPx: 64, heightPx: 64, fxPx: 64, fyPx: 64, cxPx: 32, cyPx: 32 };
const from = (x: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1];
/** A wall 4 m away, and a smaller one before it, 2 m away. */
const WALLS: CaptureMesh = {
  positions: Float32Array.of(-1, -1, -4, 1, -1, -4, 1, 1, -4, -1, 1, -4, -0.4, -0.5, -2, 0.4, -0.5, -2, 0.4, 0.5, -2, -0.4, 0.5, -2),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7),
};
const NORMALS = vertexNormals(WALLS);
const seen = (normals: Int8Array, ...places: readonly number[]) =>
  paperWeights(WALLS, normals, paperViews(WALLS, PINHOLE, places.map(from)), [0, 0, 0]);

test('sees what is in a picture, is not hidden, and is turned to the camera', () => {
  // The corners of the near wall have the far wall beside them, so the loop of the paper leaves out all four.
  expect(seen(NORMALS, 0)).toBe(4);
  expect(
    seen(
      NORMALS.map((x) => -x),
      0,
    ),
  ).toBe(0);
  // From 20 m beside, nothing is in the picture.
  expect(seen(NORMALS, 20)).toBe(0);
  // The near wall covers x from −0.2 to 1.4 m of the far one, seen from −0.6 m to the left: two corners.
  expect(seen(NORMALS, -0.6)).toBe(2);
});
