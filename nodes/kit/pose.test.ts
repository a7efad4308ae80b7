import { expect, test } from '@jest/globals';
import { createPose, writePose } from './pose.ts';

const MATRIX = [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1];

test('a pose takes a rigid matrix, and the jumps of the frame', () => {
  const pose = createPose();
  writePose(pose, MATRIX, 4);
  expect({ ...pose, worldFromPose: [...pose.worldFromPose] }).toEqual({ worldFromPose: MATRIX, valid: true, jumps: 4 });
});

test.each([
  ['nothing', null],
  ['a matrix with NaN', MATRIX.map((x, i) => (i === 13 ? Number.NaN : x))],
  ['a zero matrix', new Float32Array(16)],
  ['a matrix with an axis of length 0', MATRIX.map((x, i) => (i < 4 ? 0 : x))],
  ['a matrix with zeros in its last row', MATRIX.map((x, i) => (i === 15 ? 0 : x))],
  ['a 3×3 matrix', [1, 0, 0, 0, 1, 0, 0, 0, 1]],
])('%s is no pose', (_what, matrix) => {
  const pose = createPose();
  writePose(pose, MATRIX, 0);
  writePose(pose, matrix, 0);
  expect([pose.valid, [...pose.worldFromPose]]).toEqual([false, MATRIX]);
});
