import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Vector = readonly [number, number, number];

function look(at: Vector, target: Vector, params: { front?: string; upright?: boolean } = {}) {
  const poses = { pose: createPose(), target: createPose() };
  const matrix = new Float32Array(16);
  setFromAngles(matrix, at, [0, 0, 0]);
  writePose(poses.pose, matrix, 1);
  setFromAngles(matrix, target, [0.3, 0.2, 0.1]);
  writePose(poses.target, matrix, 2);
  const { ctx } = fakeContext(definition, { params, inputs: poses });
  const node = create(ctx);
  const step = () => {
    node.update({} as never);
    const { worldFromPose, valid, jumps } = ctx.outputs.pose;
    const column = (i: number) => [...worldFromPose.subarray(i * 4, i * 4 + 3)].map((x) => Math.round(x * 1e5) / 1e5 + 0);
    return { y: column(1), z: column(2), at: column(3), valid, jumps };
  };
  return { poses, step };
}

describe('pose/look-at', () => {
  test('turns its front to the target, with y up', () => {
    // From (1, 1, 0) to (4, 5, 0): 3 to the right and 4 up.
    expect(look([1, 1, 0], [4, 5, 0]).step()).toEqual({ y: [-0.8, 0.6, 0], z: [0.6, 0.8, 0], at: [1, 1, 0], valid: true, jumps: 3 });
    expect(look([1, 1, 0], [4, 5, 0], { front: '-z' }).step()).toMatchObject({ y: [-0.8, 0.6, 0], z: [-0.6, -0.8, 0] });
  });

  test('stays upright where it is set to', () => {
    expect(look([1, 1, 0], [4, 5, 0], { upright: true }).step()).toMatchObject({ y: [0, 1, 0], z: [1, 0, 0] });
  });

  test('keeps its rotation where the target gives no direction', () => {
    expect(look([1, 1, 0], [1, 1, 0]).step()).toMatchObject({ y: [0, 1, 0], z: [0, 0, 1], valid: true });
    expect(look([1, 1, 0], [1, 5, 0], { upright: true }).step()).toMatchObject({ y: [0, 1, 0], z: [0, 0, 1], valid: true });
  });

  test.each(['pose', 'target'] as const)('is invalid while its %s is', (which) => {
    const { poses, step } = look([1, 1, 0], [4, 5, 0]);
    writePose(poses[which], null, 0);
    expect(step().valid).toBe(false);
  });
});
