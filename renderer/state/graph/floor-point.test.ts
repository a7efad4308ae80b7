import { describe, expect, test } from '@jest/globals';
import { Matrix4, PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';
import { floorInView, floorUnder, rightOnFloor } from './floor-point.ts';

/** A view from the height of an eye, turned and tilted. */
function viewOf(pitchRad: number, yawRad = 0.4) {
  const camera = new PerspectiveCamera(60, 4 / 3, 0.1, 100);
  camera.position.set(0.5, 1.6, 2);
  camera.rotation.set(pitchRad, yawRad, 0, 'YXZ');
  camera.updateMatrixWorld();
  const top = Math.tan(Math.PI / 6);
  const tangents = { left: (-top * 4) / 3, right: (top * 4) / 3, bottom: -top, top };
  return { camera, view: { worldFromView: [...new Matrix4().copy(camera.matrixWorld).elements], tangents } };
}

describe('the floor under a point of the picture', () => {
  test.each([
    [0.5, 0.8],
    [0.2, 0.95],
    [0.9, 0.7],
  ])('is where the ray of three.js at %d, %d meets it', (x, y) => {
    const { camera, view } = viewOf(-0.5);
    const raycaster = new Raycaster();
    raycaster.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), camera);
    const { origin, direction } = raycaster.ray;
    const hit = origin.clone().addScaledVector(direction, -origin.y / direction.y);
    const [hitX, hitZ] = floorUnder(view, x, y);
    expect(hitX).toBeCloseTo(hit.x, 5);
    expect(hitZ).toBeCloseTo(hit.z, 5);
  });

  test('is 5 m away above the horizon, in the direction of the pointer', () => {
    const { camera, view } = viewOf(0);
    const [x, z] = floorUnder(view, 0.5, 0.2);
    const ahead = new Vector3(0, 0, -1).transformDirection(camera.matrixWorld);
    expect(x).toBeCloseTo(0.5 + 5 * ahead.x, 5);
    expect(z).toBeCloseTo(2 + 5 * ahead.z, 5);
  });

  test('is before a visitor at the origin while nothing is shown', () => {
    expect(floorUnder(null, 0.3, 0.9)).toEqual([0, -1.5]);
    expect(floorInView(null)).toEqual([0, -1.5]);
  });
});

test('a model that is dropped elsewhere stands at most 3 m away, where the picture shows that floor', () => {
  for (const pitchRad of [-0.2, -0.5, -0.9]) {
    const [x, z] = floorInView(viewOf(pitchRad).view);
    expect(Math.hypot(x - 0.5, z - 2)).toBeLessThanOrEqual(3);
  }
});

test('the right of the picture on the floor is that of the camera, also of one that looks down', () => {
  for (const pitchRad of [0, -0.5, -1.5]) {
    const { camera, view } = viewOf(pitchRad, 2);
    const right = new Vector3(1, 0, 0).transformDirection(camera.matrixWorld);
    expect(rightOnFloor(view)).toEqual([expect.closeTo(right.x, 6), expect.closeTo(right.z, 6)]);
  }
  expect(rightOnFloor(null)).toEqual([1, 0]);
});
