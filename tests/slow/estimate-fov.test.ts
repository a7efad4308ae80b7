import { describe, expect, test } from '@jest/globals';
import { Euler, Matrix4, Vector3 } from 'three';
import { createRandom } from '../../export/runtime/random.ts';
import { createFovEstimator } from '../../export/runtime/sessions/camera/estimate-fov.ts';

const WIDTH = 80;
const HEIGHT = 45;
const RATE_HZ = 30;
const GUESS = Math.tan((65 * Math.PI) / 360);

const COLUMNS = 720;
const ROWS = 360;

/** A room that is seen from its middle, as a panorama: waves of several lengths by direction, and edges. */
const PANORAMA = Float32Array.from({ length: COLUMNS * ROWS }, (_, at) => {
  const yaw = ((at % COLUMNS) / COLUMNS) * 2 * Math.PI;
  const pitch = (Math.floor(at / COLUMNS) / ROWS - 0.5) * Math.PI;
  const [x, y, z] = [Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch), Math.cos(pitch) * Math.cos(yaw)];
  let value = 0;
  for (let i = 1; i <= 7; i++) {
    value += Math.sin(i * 3.1 * x + 1.7 * i * y + i) * Math.cos(i * 2.3 * z - i * 2.9 * y + 2 * i);
    value += Math.sign(Math.sin(i * 2.1 * (x - z) + i)) / 3;
  }
  return value;
});

function lookAt({ x, y, z }: Vector3): number {
  const column = ((Math.atan2(x, z) / (2 * Math.PI) + 1) % 1) * COLUMNS;
  const row = (Math.asin(y) / Math.PI + 0.5) * ROWS;
  const [c, r] = [Math.floor(column), Math.floor(row)];
  const at = (dc: number, dr: number) => PANORAMA[Math.min(ROWS - 1, r + dr) * COLUMNS + ((c + dc) % COLUMNS)] ?? 0;
  const [s, t] = [column - c, row - r];
  return (at(0, 0) * (1 - s) + at(1, 0) * s) * (1 - t) + (at(0, 1) * (1 - s) + at(1, 1) * s) * t;
}

/** A hand that looks around for some seconds. */
function handAt(timeS: number): Matrix4 {
  const euler = new Euler(-0.2 + 0.12 * Math.sin(2.3 * timeS), 0.6 * Math.sin(1.1 * timeS), 0.05 * Math.sin(1.7 * timeS), 'YXZ');
  return new Matrix4().makeRotationFromEuler(euler);
}

/** Rounded to 0.1°, as browsers do it. */
function readSensor(pose: Matrix4): Matrix4 {
  const { x, y, z } = new Euler().setFromRotationMatrix(pose, 'YXZ');
  const round = (rad: number) => (Math.round((rad * 1800) / Math.PI) / 1800) * Math.PI;
  return new Matrix4().makeRotationFromEuler(new Euler(round(x), round(y), round(z), 'YXZ'));
}

function imageAt(pose: Matrix4, focalPx: number, width: number, height: number, noise: () => number): Float32Array {
  const direction = new Vector3();
  return Float32Array.from({ length: width * height }, (_, i) => {
    direction.set(((i % width) - (width - 1) / 2) / focalPx, -(Math.floor(i / width) - (height - 1) / 2) / focalPx, -1);
    return lookAt(direction.normalize().transformDirection(pose)) + noise();
  });
}

function estimate(fovDeg: number, seconds: number, [width, height]: readonly [number, number] = [WIDTH, HEIGHT]) {
  const focalPx = Math.max(width, height) / (2 * Math.tan((fovDeg * Math.PI) / 360));
  const random = createRandom(fovDeg, 'camera');
  const estimator = createFovEstimator(GUESS);
  for (let frame = 0; frame < seconds * RATE_HZ; frame++) {
    const pose = handAt(frame / RATE_HZ);
    const picture = imageAt(pose, focalPx, width, height, () => 0.2 * (random.next() - 0.5));
    estimator.add(picture, width, height, readSensor(pose).elements);
  }
  return estimator.tanHalfLongSide;
}

describe.each([50, 58, 68, 78])('a camera of %d°', (fovDeg) => {
  const truth = Math.tan((fovDeg * Math.PI) / 360);
  const found = estimate(fovDeg, 5) ?? Number.NaN;

  test('is known to 3 % after 5 s', () => {
    const foundDeg = (Math.atan(found) * 360) / Math.PI;
    expect(Math.abs(foundDeg / fovDeg - 1)).toBeLessThan(0.03);
  });

  test('a point of the floor then stays within 1 % of the width over a turn of 90°', () => {
    // Across the picture, as a share of its width, from the middle; beyond the border it is not seen.
    const across = (yawRad: number, tanHalf: number) => Math.tan(yawRad) / (2 * tanHalf);
    const half = (45 * Math.PI) / 180;
    for (let yawRad = -half; yawRad <= half; yawRad += 0.01) {
      if (Math.abs(across(yawRad, truth)) > 0.5) continue;
      expect(Math.abs(across(yawRad, found) - across(yawRad, truth))).toBeLessThan(0.01);
    }
  });
});

test('an upright picture is as good', () => {
  const found = estimate(68, 5, [HEIGHT, WIDTH]) ?? Number.NaN;
  expect(found / Math.tan((68 * Math.PI) / 360)).toBeCloseTo(1, 1.5);
});

test('nothing is known of a camera that rests, or whose picture does not move with it', () => {
  const random = createRandom(1, 'noise');
  const resting = createFovEstimator(GUESS);
  const loose = createFovEstimator(GUESS);
  for (let frame = 0; frame < 150; frame++) {
    const noise = Float32Array.from({ length: WIDTH * HEIGHT }, () => random.next());
    resting.add(noise.slice(), WIDTH, HEIGHT, new Matrix4().elements);
    loose.add(noise, WIDTH, HEIGHT, handAt(frame / RATE_HZ).elements);
  }
  expect([resting.tanHalfLongSide, loose.tanHalfLongSide]).toEqual([null, null]);
});
