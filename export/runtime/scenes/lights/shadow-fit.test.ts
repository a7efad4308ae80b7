import { describe, expect, test } from '@jest/globals';
import { Sphere, Vector3 } from 'three';
import { createShadowFit, fitShadow } from './shadow-fit.ts';

function sphere(x: number, y: number, z: number, radius = 0.1): Sphere {
  return new Sphere(new Vector3(x, y, z), radius);
}

function fitted(towards: readonly [number, number, number], casters: Sphere[], areaM = 4, mapSizePx = 1024) {
  const fit = createShadowFit();
  fitShadow(fit, new Vector3(...towards).normalize().toArray(), casters, areaM, mapSizePx);
  /** Map UV and depth of a world point. */
  const map = (x: number, y: number, z: number): Vector3 => new Vector3(x, y, z).applyMatrix4(fit.mapFromWorld);
  return { fit, map };
}

describe('fitShadow', () => {
  test.each<[string, [number, number, number]]>([
    ['above', [0, 1, 0]],
    ['below', [0, -1, 0]],
    ['the side', [1, 0, 0]],
    ['aslant', [-0.4, 0.8, 0.5]],
  ])('with light from %s, points along a ray share a texel and grow deeper away from the light', (_where, towards) => {
    const { map } = fitted(towards, [sphere(0.3, 1, -0.2)]);
    const ray = new Vector3(...towards).normalize();
    const near = map(0.3, 1, -0.2);
    const far = map(0.3 - ray.x, 1 - ray.y, -0.2 - ray.z);
    expect(far.x).toBeCloseTo(near.x, 9);
    expect(far.y).toBeCloseTo(near.y, 9);
    expect(far.z).toBeGreaterThan(near.z);
    expect(near.z).toBeGreaterThan(0);
    expect(far.z).toBeLessThan(1);
  });

  test('lays the square around the middle of all casters, within half a texel', () => {
    const { map } = fitted([0, 1, 0], [sphere(1, 0, 0), sphere(3, 0, 1)]);
    const middle = map(2, 0, 0.5);
    expect(Math.abs(middle.x - 0.5)).toBeLessThanOrEqual(0.5 / 1024 + 1e-9);
    expect(Math.abs(middle.y - 0.5)).toBeLessThanOrEqual(0.5 / 1024 + 1e-9);
    // 2 m to the side of the middle is the edge of 4 m.
    expect(Math.abs(map(4, 0, 0.5).x - middle.x)).toBeCloseTo(0.5, 9);
  });

  test('moves in whole texels, so that edges do not crawl', () => {
    const fractions = [0, 0.0003, 0.0011, 0.0027, 1.2345].map((x) => {
      const { map } = fitted([0.3, 0.9, 0.2], [sphere(x, 0, x / 3)]);
      // Where a fixed point of the world lies within its texel.
      const { x: u, y: v } = map(0.5, 0.25, -0.5);
      return [u * 1024, v * 1024].map((texel) => Math.round((texel - Math.floor(texel)) * 1e6) / 1e6);
    });
    for (const fraction of fractions) expect(fraction).toEqual(fractions[0]);
  });

  test('keeps casters that stand towards the light, and reaches 60 m behind them', () => {
    const { map } = fitted([0, 1, 0], [sphere(0, 0, 0), sphere(0, 8, 0, 1)]);
    expect(map(0, 9, 0).z).toBeGreaterThan(0);
    expect(map(0, -50, 0).z).toBeLessThan(1);
  });

  test('gives a map around the origin without casters', () => {
    const { map } = fitted([0, 1, 0], []);
    expect(map(0, 0, 0).x).toBeCloseTo(0.5, 9);
  });
});
