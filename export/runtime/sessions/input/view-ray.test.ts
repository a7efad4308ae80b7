import { expect, test } from '@jest/globals';
import { Matrix4, PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';
import { writeViewRay } from './view-ray.ts';

test.each([
  [0.5, 0.5],
  [0, 0],
  [1, 0.25],
  [0.2, 0.9],
])('the ray through %d, %d is that of three.js, in a rigid frame', (u, v) => {
  const camera = new PerspectiveCamera(70, 1.6, 0.05, 100);
  camera.position.set(1, 2, 3);
  camera.rotation.set(-0.4, 0.9, 0.3);
  camera.updateMatrixWorld();
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2(2 * u - 1, 2 * v - 1), camera);

  const out = new Float32Array(16);
  writeViewRay(
    out,
    { clipFromView: new Float32Array(camera.projectionMatrix.elements), worldFromView: new Float32Array(camera.matrixWorld.elements) },
    u,
    v,
  );
  const worldFromRay = new Matrix4().fromArray(out);
  const origin = new Vector3().setFromMatrixPosition(worldFromRay);
  const direction = new Vector3(0, 0, -1).transformDirection(worldFromRay);
  expect(origin.distanceTo(caster.ray.origin)).toBeLessThan(1e-5);
  expect(direction.distanceTo(caster.ray.direction)).toBeLessThan(1e-5);
  expect(worldFromRay.determinant()).toBeCloseTo(1, 5);
  expect(new Matrix4().copy(worldFromRay).transpose().multiply(worldFromRay).elements.slice(0, 3)).toEqual([
    expect.closeTo(1, 5),
    expect.closeTo(0, 5),
    expect.closeTo(0, 5),
  ]);
});
