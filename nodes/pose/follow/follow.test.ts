import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(timeConstantS: number) {
  const pose = createPose();
  const { ctx, tick } = fakeContext(definition, { params: { timeConstantS }, inputs: { pose } });
  const node = create(ctx);
  const matrix = new Float32Array(16);
  const put = (xM: number, yawRad: number, jumps = 0) => {
    setFromAngles(matrix, [xM, 0, 0], [0, yawRad, 0]);
    writePose(pose, matrix, jumps);
  };
  /** x and yaw of the output, or null while it is invalid. */
  const step = (deltaS: number) => {
    tick(deltaS);
    node.update({} as never);
    const { worldFromPose, valid } = ctx.outputs.pose;
    return valid ? [worldFromPose[12], Math.atan2(worldFromPose[8] ?? 0, worldFromPose[10] ?? 0)] : null;
  };
  return { ctx, node, pose, put, step };
}

const near = (xM: number, yawRad: number) => [expect.closeTo(xM, 5), expect.closeTo(yawRad, 5)];

describe('pose/follow', () => {
  test.each([10, 60, 144])('has 1 / e of the way left after a time constant, at %d frames per second', (rate) => {
    const { put, step } = start(1);
    put(0, 0);
    expect(step(0)).toEqual(near(0, 0));
    put(2, 1);
    for (let i = 0; i < rate - 1; i++) step(1 / rate);
    const done = 1 - Math.exp(-1);
    expect(step(1 / rate)).toEqual(near(2 * done, done));
  });

  test('turns along the shorter way', () => {
    const { put, step } = start(1);
    put(0, 3);
    step(0);
    put(0, -3);
    // The way is 2π - 6 rad, through π; half of it ends at π.
    const [, yaw = 0] = step(Math.log(2)) ?? [];
    expect(Math.abs(yaw ?? 0)).toBeCloseTo(Math.PI, 4);
  });

  test('starts again on a jump, after an invalid pose and after a reset, and follows at once without a time constant', () => {
    const { ctx, node, pose, put, step } = start(1);
    put(0, 0);
    step(0);
    put(5, 1, 1);
    expect(step(0.1)).toEqual(near(5, 1));
    expect(ctx.outputs.pose.jumps).toBe(1);
    writePose(pose, null, 1);
    expect(step(0.1)).toBe(null);
    put(7, 0, 1);
    expect(step(0.1)).toEqual(near(7, 0));
    node.reset?.();
    put(8, 0, 1);
    expect(step(0.1)).toEqual(near(8, 0));
    const quick = start(0);
    quick.put(0, 0);
    quick.step(0.1);
    quick.put(3, 0.5);
    expect(quick.step(0.1)).toEqual(near(3, 0.5));
  });
});
