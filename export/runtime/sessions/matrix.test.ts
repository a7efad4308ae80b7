import { expect, test } from '@jest/globals';
import { Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { createMatrix, setFrustum, setRigidInverse } from './matrix.ts';

function closeTo(actual: ArrayLike<number>, expected: readonly number[]): void {
  Array.from(actual).forEach((value, i) => {
    expect(value).toBeCloseTo(expected[i] ?? Number.NaN, 4);
  });
}

test("a symmetric frustum is three's perspective camera", () => {
  const camera = new PerspectiveCamera(50, 16 / 9, 0.1, 100);
  const y = Math.tan((25 * Math.PI) / 180);
  const m = createMatrix();
  setFrustum(m, (-y * 16) / 9, (y * 16) / 9, -y, y, 0.1, 100);
  closeTo(m, camera.projectionMatrix.elements);
});

test("an off-axis frustum is three's, too", () => {
  const m = createMatrix();
  setFrustum(m, -0.3, 0.5, -0.2, 0.7, 0.1, 100);
  closeTo(m, new Matrix4().makePerspective(-0.03, 0.05, 0.07, -0.02, 0.1, 100).elements);
});

test('the inverse of a pose is its inverse', () => {
  const pose = new Matrix4().compose(new Vector3(1, -2, 3), new Quaternion(0.5, -0.1, 0.2, 0.7).normalize(), new Vector3(1, 1, 1));
  const m = createMatrix();
  setRigidInverse(m, pose.elements);
  closeTo(m, pose.clone().invert().elements);
});
