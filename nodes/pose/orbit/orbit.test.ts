import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, type PoseOutput, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

function start(params: Params = {}, center: PoseOutput | null = null) {
  const fake = fakeContext(definition, { params, inputs: { center } });
  const node = create(fake.ctx);
  const step = (deltaS: number) => {
    fake.tick(deltaS);
    node.update({ jumps: 0 } as never);
    const { worldFromPose, valid } = fake.ctx.outputs.pose;
    const column = (i: number) => [...worldFromPose.subarray(i * 4, i * 4 + 3)].map((x) => Math.round(x * 1e5) / 1e5 + 0);
    return { y: column(1), z: column(2), at: column(3), valid };
  };
  return { ...fake, step };
}

describe('pose/orbit', () => {
  test('moves counterclockwise around the y axis, with z ahead', () => {
    const { step } = start({ radiusM: 2, heightM: 1, speedHz: 0.25 });
    expect(step(0)).toEqual({ y: [0, 1, 0], z: [0, 0, -1], at: [2, 1, 0], valid: true });
    expect(step(1)).toEqual({ y: [0, 1, 0], z: [-1, 0, 0], at: [0, 1, -2], valid: true });
    expect(step(1)).toMatchObject({ z: [0, 0, 1], at: [-2, 1, 0] });
    expect(step(2)).toMatchObject({ z: [0, 0, -1], at: [2, 1, 0] });
  });

  test.each([
    ['inwards', [-1, 0, 0]],
    ['outwards', [1, 0, 0]],
    ['keep', [0, 0, 1]],
  ] as const)('can point its front %s', (front, z) => {
    expect(start({ front, speedHz: 0 }).step(5)).toMatchObject({ z, at: [0.5, 0, 0] });
  });

  test('starts at the angle, and turns the other way with a negative speed', () => {
    const { step } = start({ radiusM: 1, angleRad: Math.PI / 2, speedHz: -0.25 });
    expect([step(0).at, step(1).at]).toEqual([
      [0, 0, -1],
      [1, 0, 0],
    ]);
  });

  test('follows the center and its axes, and is invalid while it is', () => {
    const center = createPose();
    const matrix = new Float32Array(16);
    // On its side: y of the center is x of the world.
    setFromAngles(matrix, [5, 1, 0], [0, 0, -Math.PI / 2]);
    writePose(center, matrix, 0);
    const { step } = start({ radiusM: 2, speedHz: 0.25 }, center);
    expect(step(0)).toMatchObject({ y: [1, 0, 0], at: [5, -1, 0], valid: true });
    expect(step(1)).toMatchObject({ at: [5, 1, -2] });
    center.valid = false;
    expect(step(0).valid).toBe(false);
  });
});
