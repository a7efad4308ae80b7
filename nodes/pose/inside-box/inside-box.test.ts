import { describe, expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { createPose, type PoseOutput, writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(marginM: number, box: PoseOutput | null = null) {
  const pose = createPose();
  const { ctx, tick } = fakeContext(definition, { params: { sizeM: [2, 1, 4], marginM }, inputs: { pose, box } });
  const node = create(ctx);
  /** `+` where it enters, `-` where it leaves, and whether it is inside. */
  const step = (at: readonly [number, number, number] | null) => {
    if (at) setFromAngles(matrix, at, [0, 0, 0]);
    writePose(pose, at && matrix, 0);
    tick(0.1);
    node.update({} as never);
    const { inside, entered, left } = ctx.outputs;
    return `${'+'.repeat(entered.count)}${'-'.repeat(left.count)} ${inside.value}`;
  };
  const matrix = new Float32Array(16);
  return { ctx, node, step };
}

describe('pose/inside-box', () => {
  test('pulses when the pose enters and leaves', () => {
    const { ctx, step } = start(0);
    expect([step([0.9, 0.4, -1.9]), ctx.outputs.entered.at(0).worldFromPose?.[12]]).toEqual(['+ true', expect.closeTo(0.9, 6)]);
    expect([step([0, 0, 0]), step([1.1, 0, 0]), step([0, 0.6, 0]), step([0, 0, 2.1])]).toEqual([' true', '- false', ' false', ' false']);
  });

  test('is left only beyond the margin', () => {
    const { step } = start(0.2);
    expect([step([1.1, 0, 0]), step([0.9, 0, 0]), step([1.1, 0, 0]), step([1.3, 0, 0]), step([1.1, 0, 0])]).toEqual([
      ' false',
      '+ true',
      ' true',
      '- false',
      ' false',
    ]);
  });

  test('is centered on its pose and turned with it', () => {
    const box = createPose();
    const matrix = new Float32Array(16);
    // A quarter turn about y: the 4 m lie along x.
    setFromAngles(matrix, [10, 0, 0], [0, Math.PI / 2, 0]);
    const { step } = start(0, box);
    expect(step([10, 0, 0])).toBe(' false');
    writePose(box, matrix, 0);
    expect([step([11.9, 0, 0]), step([10, 0, 1.1])]).toEqual(['+ true', '- false']);
    step([10, 0, 0]);
    writePose(box, null, 0);
    expect(step([10, 0, 0])).toBe('- false');
  });

  test('is left by a pose that becomes invalid, and is empty after a reset', () => {
    const { ctx, node, step } = start(0);
    step([0, 0, 0]);
    expect([step(null), ctx.outputs.left.at(0).worldFromPose]).toEqual(['- false', null]);
    step([0, 0, 0]);
    node.reset?.();
    expect(step([0, 0, 0])).toBe('+ true');
  });
});
