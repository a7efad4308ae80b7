import { describe, expect, test } from '@jest/globals';
import { Euler, MathUtils, Matrix4, Quaternion, Vector3 } from 'three';
import { createMatrix } from '../../export/runtime/sessions/matrix.ts';
import {
  clockwiseTurn,
  type DeviceAngles,
  setDeviceAngles,
  setDeviceRotation,
  setUpright,
  turnAboutVertical,
  yawToFront,
} from './device-orientation.ts';

const angles = (alpha: number, beta: number, gamma: number, screen = 0): DeviceAngles => ({
  alphaRad: MathUtils.degToRad(alpha),
  betaRad: MathUtils.degToRad(beta),
  gammaRad: MathUtils.degToRad(gamma),
  screenRad: MathUtils.degToRad(screen),
});

function rotation(given: DeviceAngles): Float32Array {
  const m = createMatrix();
  setDeviceRotation(m, given);
  return m;
}

const direction = (m: Float32Array, x: number, y: number, z: number): number[] =>
  new Vector3(x, y, z)
    .transformDirection(new Matrix4().fromArray(m))
    .toArray()
    .map((v) => Number(v.toFixed(5)) + 0);
const forward = (m: Float32Array) => direction(m, 0, 0, -1);
const up = (m: Float32Array) => direction(m, 0, 1, 0);

/** The formula of three's former DeviceOrientationControls, by quaternions. */
function byQuaternions({ alphaRad, betaRad, gammaRad, screenRad }: DeviceAngles): Matrix4 {
  const turned = new Quaternion().setFromEuler(new Euler(betaRad, alphaRad, -gammaRad, 'YXZ'));
  turned.multiply(new Quaternion(-Math.SQRT1_2, 0, 0, Math.SQRT1_2));
  turned.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), -screenRad));
  return new Matrix4().makeRotationFromQuaternion(turned);
}

describe('the pose of a device', () => {
  test('lying on a table, it looks down, its top to the north', () => {
    const m = rotation(angles(0, 0, 0));
    expect(forward(m)).toEqual([0, -1, 0]);
    expect(up(m)).toEqual([0, 0, -1]);
  });

  test('held upright, it looks ahead; turned left by alpha, to the west', () => {
    expect(forward(rotation(angles(0, 90, 0)))).toEqual([0, 0, -1]);
    expect(forward(rotation(angles(90, 90, 0)))).toEqual([-1, 0, 0]);
  });

  test('held across, the page turned with it, up stays up', () => {
    // Top to the left: the right edge is up, and the page is turned by 90°.
    const m = rotation(angles(0, 0, -90, 90));
    expect(up(m)).toEqual([0, 1, 0]);
    const other = rotation(angles(0, 0, 90, 270));
    expect(up(other)).toEqual([0, 1, 0]);
  });

  test.each([
    [12, 34, 56, 0],
    [300, -80, 20, 90],
    [181, 140, -75, 180],
    [77, 5, 88, 270],
  ])('is that of quaternions at %d, %d, %d, page at %d', (alpha, beta, gamma, screen) => {
    const given = angles(alpha, beta, gamma, screen);
    const expected = byQuaternions(given).elements;
    rotation(given).forEach((value, i) => {
      expect(value).toBeCloseTo(expected[i] ?? Number.NaN, 5);
    });
  });

  test.each([
    [0, 90, 0],
    [123, 70, 10],
    [250, 110, -30],
    // On the table and overhead there is no ahead: the top shows the way.
    [40, 0, 0],
    [200, 178, 3],
  ])('is turned to the front, whatever the compass says: %d, %d, %d', (alpha, beta, gamma) => {
    const m = rotation(angles(alpha, beta, gamma));
    turnAboutVertical(m, yawToFront(m));
    const ahead = forward(m);
    const level = Math.hypot(ahead[0] ?? 0, ahead[2] ?? 0) >= 0.3;
    const [x = 0, , z = 0] = level ? ahead : direction(m, 0, (ahead[1] ?? 0) < 0 ? 1 : -1, 0);
    expect(x).toBeCloseTo(0, 4);
    expect(z).toBeLessThan(0);
  });

  test.each([
    [12, 34, 56],
    [300, -80, 20],
    [181, 140, -75],
    [40, 0, 0],
    [123, 90, 0],
    [250, -90, 0],
  ])('gives its angles back: %d, %d, %d', (alpha, beta, gamma) => {
    const expected = rotation(angles(alpha, beta, gamma));
    const found = angles(1, 2, 3, 4);
    setDeviceAngles(found, expected);
    expect(found.screenRad).toBe(0);
    rotation(found).forEach((value, i) => {
      expect(value).toBeCloseTo(expected[i] ?? Number.NaN, 5);
    });
  });

  test('is turned clockwise against another, in any tilt', () => {
    for (const beta of [-60, 0, 45, 90, 150]) {
      const turn = clockwiseTurn(rotation(angles(20, beta, 10)), rotation(angles(95, beta, 10)));
      expect(turn).toBeCloseTo(MathUtils.degToRad(75), 5);
    }
  });

  test('without a sensor it is held upright', () => {
    const given = angles(1, 2, 3, 4);
    setUpright(given);
    expect(forward(rotation(given))).toEqual([0, 0, -1]);
    expect(up(rotation(given))).toEqual([0, 1, 0]);
  });
});
