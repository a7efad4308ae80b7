import { describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const MOVED = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] as const;

function start(params: { mode?: string; moveM?: number } = {}) {
  const poses = { a: createPose(), b: createPose(), c: createPose() };
  const { ctx } = fakeContext(definition, {
    params: { growth: 'none', acrossRad: 0, ...params },
    inputs: poses,
    services: { session: { sessions: 1 } as never },
  });
  const node = create(ctx);
  const frame = createSessionFrame();
  frame.viewCount = 1;
  const put = (name: 'a' | 'b' | 'c', at: readonly number[] | null, jumps = 0) => writePose(poses[name], at && [...MOVED, ...at, 1], jumps);
  const step = (...eye: number[]) => {
    frame.views[0]?.worldFromView.set([...MOVED, ...eye, 1]);
    node.update(frame);
    const { value, uncertainty, valid } = ctx.outputs;
    return [value.value, uncertainty.value, valid.value];
  };
  return { node, frame, put, step };
}

/** 1.96 · 0.73 cm · √2 for points along the ray, and nothing for points across it that are far away. */
const ALONG = expect.closeTo(0.0202347, 6);

describe('world/measure', () => {
  test('measures a distance once both poses are valid', () => {
    const { put, step } = start();
    put('a', [0, 0, -1]);
    expect(step(0, 0, 0)).toEqual([0, 0, false]);
    put('b', [0, 0, -3]);
    expect(step(0, 0, 0)).toEqual([2, ALONG, true]);
    put('a', null);
    expect(step(0, 0, 0)).toEqual([0, 0, false]);
  });

  test('measures a height without the other poses', () => {
    const { put, step } = start({ mode: 'height' });
    put('a', [0, 0.75, 0]);
    // From above, 1.96 · 0.73 cm.
    expect(step(0, 1.75, 0)).toEqual([0.75, expect.closeTo(0.014308, 6), true]);
  });

  test('measures an angle at B', () => {
    const { put, step } = start({ mode: 'angle' });
    put('a', [1, 0, -2]);
    put('b', [0, 0, -2]);
    expect(step(0, 0, 0)).toEqual([0, 0, false]);
    put('c', [0, 1, -2]);
    expect(step(0, 0, 0)).toEqual([expect.closeTo(Math.PI / 2, 6), expect.any(Number), true]);
  });

  test('keeps the uncertainty while the viewer walks, until a point moves, jumps or becomes invalid', () => {
    const { node, put, step } = start();
    put('a', [0, 0, -1]);
    put('b', [0, 0, -3]);
    expect(step(0, 0, 0)[1]).toEqual(ALONG);
    // From far to the side the ruler lies across the view.
    expect(step(1e6, 0, -2)[1]).toEqual(ALONG);
    put('a', [0, 0, -1.005]);
    expect(step(1e6, 0, -2)[1]).toEqual(ALONG);
    // Only A is seen from the side now: 1.96 · 0.73 cm of B are left.
    const ONE = expect.closeTo(0.014308, 6);
    put('a', [0, 0, -1.02]);
    expect(step(1e6, 0, -2)[1]).toEqual(ONE);
    put('b', [0, 0, -3], 1);
    expect(step(1e6, 0, -2)[1]).toBeCloseTo(0, 6);
    put('b', null);
    step(0, 0, 0);
    put('b', [0, 0, -3]);
    expect(step(0, 0, 0)[1]).toEqual(ONE);
    node.reset?.();
    expect(step(0, 0, 0)[1]).toEqual(ALONG);
  });

  test('uses the present line of sight where no point is kept', () => {
    const { put, step } = start({ moveM: 0 });
    put('a', [0, 0, -1]);
    put('b', [0, 0, -3]);
    expect(step(0, 0, 0)[1]).toEqual(ALONG);
    expect(step(1e6, 0, -2)[1]).toBeCloseTo(0, 6);
  });

  test('is invalid without a view', () => {
    const { frame, put, step } = start();
    put('a', [0, 0, -1]);
    put('b', [0, 0, -3]);
    frame.viewCount = 0;
    expect(step(0, 0, 0)).toEqual([0, 0, false]);
  });

  test('sees from the middle between two eyes', () => {
    const { frame, put, step } = start({ mode: 'height' });
    frame.viewCount = 2;
    frame.views[1]?.worldFromView.set([...MOVED, 2, 1, 0, 1]);
    put('a', [1, 0, 0]);
    expect(step(0, 1, 0)[1]).toBeCloseTo(0.014308, 6);
  });
});
