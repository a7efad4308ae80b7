import { describe, expect, test } from '@jest/globals';
import { Euler, Matrix4, Quaternion } from 'three';
import { aimZ, setFromAngles, setQuaternion, setRigid, turnToward } from './rigid.ts';

const ANGLES = [
  [0.3, -1.2, 2.5],
  [-1.4, 3, -0.2],
  [0, Math.PI, 0],
  [Math.PI, 0, 0],
  [0, 0, Math.PI],
] as const;

const near = (values: Iterable<number>) => [...values].map((value) => expect.closeTo(value, 5));
const matrixOf = (angles: readonly [number, number, number]) => {
  const matrix = new Float32Array(16);
  setFromAngles(matrix, [1, 2, 3], angles);
  return matrix;
};

describe('rotations', () => {
  test.each(ANGLES)('by angles are those of three in the order YXZ: %d, %d, %d', (x, y, z) => {
    const expected = new Matrix4().makeRotationFromEuler(new Euler(x, y, z, 'YXZ')).setPosition(1, 2, 3);
    expect([...matrixOf([x, y, z])]).toEqual(near(expected.elements));
  });

  test.each(ANGLES)('survive the way through a quaternion: %d, %d, %d', (x, y, z) => {
    const matrix = matrixOf([x, y, z]);
    const q = new Float64Array(4);
    setQuaternion(q, matrix);
    const back = new Float32Array(16);
    setRigid(back, [1, 2, 3], q);
    expect([...back]).toEqual(near(matrix));
  });

  test('are turned along the shorter arc, as three does it', () => {
    const from = new Quaternion(0.5, 0.5, 0.5, 0.5);
    for (const to of [new Quaternion(0, 0, 0, 1), new Quaternion(0, 0, 0, -1), new Quaternion(0.5, 0.5, 0.5, 0.5)]) {
      const q = Float64Array.from(from.toArray());
      turnToward(q, Float64Array.from(to.toArray()), 0.3);
      expect([...q]).toEqual(near(from.clone().slerp(to, 0.3).toArray()));
    }
  });
});

describe('a pose that is aimed', () => {
  const axes = (matrix: Float32Array) => [0, 4, 8].map((i) => [...matrix.subarray(i, i + 3)].map((x) => Math.round(x * 1e5) / 1e5 + 0));

  test('has z along the direction and x level', () => {
    const matrix = matrixOf([0.4, 0.5, 0.6]);
    expect(aimZ(matrix, 3, 0, 0)).toBe(true);
    expect(axes(matrix)).toEqual([
      [0, 0, -1],
      [0, 1, 0],
      [1, 0, 0],
    ]);
    aimZ(matrix, 0, 4, 3);
    expect(axes(matrix)).toEqual([
      [1, 0, 0],
      [0, 0.6, -0.8],
      [0, 0.8, 0.6],
    ]);
  });

  test('keeps its x axis where the direction is vertical', () => {
    const matrix = matrixOf([0, 0, 0]);
    aimZ(matrix, 0, -2, 0);
    expect(axes(matrix)).toEqual([
      [1, 0, 0],
      [0, 0, 1],
      [0, -1, 0],
    ]);
  });

  test('stays as it is without a direction', () => {
    const matrix = matrixOf([0.4, 0.5, 0.6]);
    expect(aimZ(matrix, 0, 0, 0)).toBe(false);
    expect([...matrix]).toEqual([...matrixOf([0.4, 0.5, 0.6])]);
  });
});
