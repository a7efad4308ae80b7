import { expect, test } from '@jest/globals';
import { type Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { worldAt } from './probe-depth.ts';

test('a point of a view at a depth is where three.js projects it from, also off the axis of a lens that is cut unevenly', () => {
  const camera = new PerspectiveCamera(60, 1.5, 0.1, 50);
  // As the left eye of a headset: 200 of 1,000 columns are missing on one side.
  camera.setViewOffset(1000, 600, 200, 30, 700, 500);
  camera.position.set(0.4, 1.6, -0.7);
  camera.rotation.set(-0.3, 0.8, 0.1);
  camera.updateMatrixWorld();
  const point = new Vector3(-1.2, 0.4, -3.1);
  const inView = point.clone().applyMatrix4(camera.matrixWorldInverse);
  const ndc = inView.clone().applyMatrix4(camera.projectionMatrix);
  const numbers = (matrix: Matrix4) => new Float32Array(matrix.elements);
  const found = worldAt(numbers(camera.projectionMatrix), numbers(camera.matrixWorld), ndc.x / 2 + 0.5, ndc.y / 2 + 0.5, -inView.z);
  expect(new Vector3(...found).distanceTo(point)).toBeLessThan(1e-4);
});
