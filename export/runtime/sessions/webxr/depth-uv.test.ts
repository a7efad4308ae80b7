import { describe, expect, test } from '@jest/globals';
import { setDepthUv } from './depth-uv.ts';

function at(m: Float32Array, u: number, v: number): number[] {
  const row = (r: number): number => (m[r] ?? 0) * u + (m[r + 3] ?? 0) * v + (m[r + 6] ?? 0);
  return [row(0) / row(2), row(1) / row(2)];
}

/** Column-major 4×4 of x' = a x + b y + c, y' = d x + e y + f. */
function affine(a: number, b: number, c: number, d: number, e: number, f: number): Float32Array {
  return Float32Array.of(a, d, 0, 0, b, e, 0, 0, 0, 0, 1, 0, c, f, 0, 1);
}

/** `XRCPUDepthInformation.getDepthInMeters`: from a point of the view, y down, to one of the buffer, y down. */
function bySpecification(m: Float32Array, x: number, y: number): number[] {
  return [(m[0] ?? 0) * x + (m[4] ?? 0) * y + (m[12] ?? 0), (m[1] ?? 0) * x + (m[5] ?? 0) * y + (m[13] ?? 0)];
}

const TRANSFORMS = {
  upright: affine(1, 0, 0, 0, 1, 0),
  'turned a quarter': affine(0, 1, 0, -1, 0, 1),
  'turned half': affine(-1, 0, 1, 0, -1, 1),
  mirrored: affine(-1, 0, 1, 0, 1, 0),
  cropped: affine(0.5, 0, 0.25, 0, 0.75, 0.1),
};

describe.each(Object.entries(TRANSFORMS))('a depth buffer %s', (_name, transform) => {
  test('is read where the specification says', () => {
    const m = new Float32Array(9);
    setDepthUv(m, transform, 'top');
    for (const [u, v] of [
      [0, 0],
      [0.2, 0.9],
      [1, 0.5],
    ] as const) {
      const [x = 0, y = 0] = bySpecification(transform, u, 1 - v);
      expect(at(m, u, v)).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
    }
  });

  test('and in a texture that begins at the bottom, upside down', () => {
    const m = new Float32Array(9);
    setDepthUv(m, transform, 'bottom');
    const [x = 0, y = 0] = bySpecification(transform, 0.3, 1 - 0.8);
    expect(at(m, 0.3, 0.8)).toEqual([expect.closeTo(x, 6), expect.closeTo(1 - y, 6)]);
  });
});
