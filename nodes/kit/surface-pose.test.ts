import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { setSurfacePose, surfaceOrientation } from './surface-pose.ts';

type Triple = readonly [number, number, number];

/** x, y and z axis of the pose at the origin, as a viewer sees it whose ray comes from `from`. */
function axes(normal: Triple, from: Triple = [0, 1.6, 2]): number[][] {
  const out = new Float32Array(16);
  setSurfacePose(out, 0, 0, 0, ...normal, ...from, from[0], from[2]);
  return [0, 4, 8].map((at) => [...out.slice(at, at + 3)].map((x) => Math.round(x * 1e6) / 1e6 + 0));
}

const X: Triple = [1, 0, 0];
const Y: Triple = [0, 1, 0];
const Z: Triple = [0, 0, 1];

describe('a pose on a surface', () => {
  test('on the floor has y up and z towards the viewer', () => {
    expect(axes(Y)).toEqual([X, Y, Z]);
    expect(axes([0, 5, 0], [3, 1.6, 0])).toEqual([[0, 0, -1], Y, X]);
  });

  test('on a wall has y towards the viewer, z down and x to the right', () => {
    expect(axes(Z)).toEqual([X, Z, [0, -1, 0]]);
  });

  test('on a ceiling has y down', () => {
    expect(axes([0, -1, 0], [0, -1, 2])).toEqual([[-1, 0, 0], [0, -1, 0], Z]);
  });

  test('turns a normal that faces away to the side of the ray', () => {
    expect(axes([0, -1, 0])).toEqual(axes(Y));
  });

  test('is rigid on a slope, also where the viewer stands right above', () => {
    for (const [normal, from] of [
      [
        [0.3, 0.9, -0.2],
        [0, 1.6, 0],
      ],
      [
        [0.8, 0.3, 0.5],
        [1, 1, 1],
      ],
      [Y, [0, 2, 0]],
    ] as const) {
      const out = new Float32Array(16);
      setSurfacePose(out, 0, 0, 0, normal[0], normal[1], normal[2], from[0], from[1], from[2], from[0], from[2]);
      const m = new Matrix4().fromArray(out);
      expect(m.determinant()).toBeCloseTo(1, 6);
      const [x, y, z] = [0, 1, 2].map((i) => new Vector3().setFromMatrixColumn(m, i)) as [Vector3, Vector3, Vector3];
      for (const axis of [x, y, z]) expect(axis.length()).toBeCloseTo(1, 6);
      expect(Math.abs(x.dot(y)) + Math.abs(y.dot(z))).toBeLessThan(1e-6);
      expect(y.dot(new Vector3(...normal).normalize())).toBeCloseTo(1, 6);
    }
  });

  test.each([
    [0, 'floor'],
    [19, 'floor'],
    [21, 'sloped'],
    [69, 'sloped'],
    [71, 'wall'],
    [109, 'wall'],
    [111, 'sloped'],
    [161, 'ceiling'],
    [180, 'ceiling'],
  ] as const)('whose normal is %d° from up lies on a %s', (degrees, orientation) => {
    const angle = (degrees * Math.PI) / 180;
    const out = new Float32Array(16);
    out[5] = Math.cos(angle);
    expect(surfaceOrientation(out)).toBe(orientation);
  });
});
