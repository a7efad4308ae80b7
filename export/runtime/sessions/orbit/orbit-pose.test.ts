import { describe, expect, test } from '@jest/globals';
import { Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { createMatrix } from '../matrix.ts';
import { createOrbit, ORBIT_DEFAULTS } from './orbit-pose.ts';

function pose(orbit: ReturnType<typeof createOrbit>): Matrix4 {
  const m = createMatrix();
  orbit.writeWorldFromView(m);
  return new Matrix4().fromArray(m);
}

describe('an orbit', () => {
  test('looks at its point from its distance, level with the horizon', () => {
    const orbit = createOrbit({ targetWorld: [1, 0.5, -2], distanceM: 3, azimuthRad: 0.7, elevationRad: 0.4 });
    const camera = new PerspectiveCamera();
    camera.position.setFromMatrixPosition(pose(orbit));
    camera.lookAt(1, 0.5, -2);
    camera.updateMatrixWorld();
    pose(orbit).elements.forEach((value, i) => {
      expect(value).toBeCloseTo(camera.matrixWorld.elements[i] ?? Number.NaN, 5);
    });
    expect(camera.position.distanceTo(new Vector3(1, 0.5, -2))).toBeCloseTo(3, 6);
  });

  test('never turns over, and zooms within reason', () => {
    const orbit = createOrbit(ORBIT_DEFAULTS);
    orbit.rotate(0, 100);
    expect(pose(orbit).elements[5]).toBeGreaterThan(0);
    for (let i = 0; i < 200; i++) orbit.zoom(1.5);
    expect(orbit.distanceM).toBeCloseTo(0.2, 6);
    for (let i = 0; i < 200; i++) orbit.zoom(0.5);
    expect(orbit.distanceM).toBeCloseTo(30, 6);
  });

  test('moves its point along the axes of the picture', () => {
    const orbit = createOrbit({ targetWorld: [0, 0, 0], distanceM: 2, azimuthRad: 0.9, elevationRad: -0.3 });
    const before = pose(orbit);
    orbit.pan(0.5, -0.25);
    const moved = new Vector3().setFromMatrixPosition(before.clone().invert().multiply(pose(orbit)));
    expect([moved.x, moved.y, moved.z].map((v) => Number(v.toFixed(6)))).toEqual([0.5, -0.25, expect.closeTo(0)]);
  });

  test('goes back where it began', () => {
    const orbit = createOrbit(ORBIT_DEFAULTS);
    const before = pose(orbit).elements;
    orbit.rotate(1, 0.2);
    orbit.zoom(2);
    orbit.pan(1, 1);
    orbit.reset();
    expect(pose(orbit).elements).toEqual(before);
  });
});
