import { describe, expect, test } from '@jest/globals';
import { createSessionInput } from '../../../export/runtime/sessions/input/session-input.ts';
import { captureHand } from '../../../tests/support/captured-hand.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

function start(side: 'left' | 'right' = 'left', joint: (typeof definition.params.joint.options)[number]['value'] = 'thumb-tip') {
  const fake = fakeContext(definition, { params: { side, joint } });
  const node = create(fake.ctx);
  const input = createSessionInput();
  const { outputs } = fake.ctx;
  const frame = (pose: Parameters<typeof captureHand>[0] | null, xM = 0, jumps = 0) => {
    if (pose) captureHand(pose, xM, input.leftHand);
    else input.leftHand.tracked = false;
    fake.tick(1 / 60);
    node.update({ input, jumps } as never);
    return {
      pulses: [outputs.pinched.count, outputs.released.count],
      strengths: [outputs.pinch.value, outputs.grab.value],
      valid: [outputs.joint.valid, outputs.palm.valid, outputs.tracked.value],
    };
  };
  return { input, outputs, frame, reset: () => node.reset?.() };
}

describe('input/hand', () => {
  test('gives the chosen joint and the palm, in world space', () => {
    const { input, outputs, frame } = start();
    expect(frame('relaxed', 2, 5).valid).toEqual([true, true, true]);
    expect([...outputs.joint.worldFromPose]).toEqual([...input.leftHand.worldFromJoints.slice(64, 80)]);
    expect(outputs.joint.jumps).toBe(5);
    expect(outputs.palm.worldFromPose[12]).toBeCloseTo(1.97, 1);
  });

  test('is invalid for the other hand, and for one that is not tracked', () => {
    expect(start('right').frame('relaxed').valid).toEqual([false, false, false]);
    const { frame } = start();
    frame('pinch');
    expect(frame(null)).toMatchObject({ valid: [false, false, false], strengths: [0, 0] });
  });

  test('a NaN among the joints makes its pose invalid', () => {
    const { input, outputs, frame } = start();
    frame('relaxed', Number.NaN);
    expect([input.leftHand.tracked, outputs.joint.valid, outputs.palm.valid]).toEqual([true, false, false]);
  });

  test('gives one pulse per pinch, with the pose between the tips', () => {
    const { outputs, frame } = start();
    expect([frame('relaxed').pulses, frame('pinch', 1).pulses, frame('pinch').pulses]).toEqual([
      [0, 0],
      [1, 0],
      [0, 0],
    ]);
    expect(frame('relaxed').pulses).toEqual([0, 1]);
    expect(outputs.released.at(0)).toMatchObject({ number: 1 });
    expect(frame('pinch', 1).pulses).toEqual([1, 0]);
    expect(outputs.pinched.at(0).worldFromPose?.[12]).toBeCloseTo(0.985, 1);
  });

  test('a pinch whose hand is lost is released where it was, with the number 0', () => {
    const { outputs, frame } = start();
    frame('pinch', 3);
    expect(frame(null).pulses).toEqual([0, 1]);
    const { number, worldFromPose } = outputs.released.at(0);
    expect([number, worldFromPose?.[12]]).toEqual([0, expect.closeTo(3, 0)]);
    expect(frame(null).pulses).toEqual([0, 0]);
  });

  test('a fist grabs and does not pinch', () => {
    expect(start().frame('fist')).toMatchObject({ strengths: [0, 1], pulses: [0, 0] });
  });

  test('after a reset, a hand that still pinches pinches anew', () => {
    const { frame, reset } = start();
    frame('pinch');
    reset();
    expect(frame('pinch').pulses).toEqual([1, 0]);
  });

  test('all joints have names of their own', () => {
    const labels = definition.params.joint.options.map(({ label }) => label);
    expect([labels.length, new Set(labels).size]).toEqual([25, 25]);
    expect(labels.slice(0, 5)).toEqual(['Wrist', 'Thumb: base', 'Thumb: knuckle', 'Thumb: last joint', 'Thumb: tip']);
    expect(labels.at(-1)).toBe('Little finger: tip');
  });
});
