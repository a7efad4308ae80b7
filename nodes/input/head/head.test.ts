import { describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(viewCount: number) {
  const { ctx } = fakeContext(definition);
  const node = create(ctx);
  const frame = createSessionFrame();
  frame.viewCount = viewCount;
  const put = (view: number, xM: number, yawRad: number) => {
    const matrix = frame.views[view]?.worldFromView;
    if (matrix) setFromAngles(matrix, [xM, 1.6, 0], [0, yawRad, 0]);
  };
  const step = () => {
    node.update(frame);
    const { worldFromPose, valid } = ctx.outputs.pose;
    return valid ? [...worldFromPose.slice(12, 15), Math.atan2(worldFromPose[8] ?? 0, worldFromPose[10] ?? 0)] : null;
  };
  return { ctx, frame, put, step };
}

const near = (values: readonly number[]) => values.map((value) => expect.closeTo(value, 5));

describe('input/head', () => {
  test('is the camera of a screen, and jumps with world space', () => {
    const { ctx, frame, put, step } = start(1);
    frame.jumps = 3;
    put(0, 2, 0.5);
    expect(step()).toEqual(near([2, 1.6, 0, 0.5]));
    expect(ctx.outputs.pose.jumps).toBe(3);
  });

  test('is the middle between two eyes', () => {
    const { put, step } = start(2);
    put(0, 0.97, 0.1);
    put(1, 1.03, -0.1);
    expect(step()).toEqual(near([1, 1.6, 0, 0]));
  });

  test('is invalid without a view', () => {
    expect(start(0).step()).toBe(null);
  });
});
