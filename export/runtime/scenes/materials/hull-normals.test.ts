import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, BufferGeometry, Float32BufferAttribute, PlaneGeometry, SphereGeometry, Vector3 } from 'three';
import { ensureHullNormals } from './hull-normals.ts';

function hullNormalsOf(geometry: BufferGeometry): Vector3[] {
  ensureHullNormals(geometry);
  const { scrimHullNormal } = geometry.attributes;
  if (!scrimHullNormal) throw new Error('There is no such attribute.');
  return Array.from({ length: scrimHullNormal.count }, (_, i) => new Vector3().fromBufferAttribute(scrimHullNormal, i));
}

/** Rounded, and without the sign of zero. */
const round = (value: number): number => Math.round(value * 1e5) / 1e5 + 0;

describe('outward', () => {
  test('of a box’s corner moves all three faces by one, whatever the vertex’s own normal and however the sides are cut', () => {
    const geometry = new BoxGeometry(2, 4, 6, 1, 2, 1);
    const { position } = geometry.attributes;
    const corners = hullNormalsOf(geometry).filter((_, i) => Math.abs(position?.getY(i) ?? 0) === 2);
    expect(corners.length).toBeGreaterThan(20);
    for (const { x, y, z } of corners) expect([x, y, z].map(Math.abs).map(round)).toEqual([1, 1, 1]);
  });

  test('of smooth and of flat shapes is the normal', () => {
    const sphere = new SphereGeometry(2, 64, 32);
    const { normal } = sphere.attributes;
    const angles = hullNormalsOf(sphere).map((outward, i) => outward.angleTo(new Vector3().fromBufferAttribute(normal as never, i)));
    expect(Math.max(...angles)).toBeLessThan(0.05);
    for (const outward of hullNormalsOf(new PlaneGeometry(1, 1, 3, 3))) expect(outward.toArray().map(round)).toEqual([0, 0, 1]);
  });

  test('of a blade that is folded onto itself is no longer than two', () => {
    const blade = new BufferGeometry();
    blade.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0.01, 0, 0, 0, 0, 1, -0.01, 1, 0, 0], 3));
    for (const outward of hullNormalsOf(blade)) expect(outward.length()).toBeLessThanOrEqual(2 + 1e-6);
  });

  test('is worked out once, and not at all without positions', () => {
    const geometry = new BoxGeometry();
    ensureHullNormals(geometry);
    const { scrimHullNormal } = geometry.attributes;
    ensureHullNormals(geometry);
    expect(geometry.attributes.scrimHullNormal).toBe(scrimHullNormal);
    expect(() => ensureHullNormals(new BufferGeometry())).not.toThrow();
  });
});
