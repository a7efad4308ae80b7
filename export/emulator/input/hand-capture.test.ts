import { describe, expect, test } from '@jest/globals';
import { pinchHandPose } from 'iwer/lib/device/configs/hand/pinch.js';
import { pointHandPose } from 'iwer/lib/device/configs/hand/point.js';
import { createSessionInput } from '../../../export/runtime/sessions/input/session-input.ts';
import { HAND_JOINTS } from '../../../nodes/kit/hand-joints.ts';
import { grabStrength, pinchStrength } from '../../../nodes/kit/hands.ts';
import { closeIndexFinger, type HandCapture, readHandCapture } from './hand-capture.ts';

function handOf({ jointTransforms }: HandCapture) {
  const hand = createSessionInput().leftHand;
  HAND_JOINTS.forEach((joint, i) => {
    hand.worldFromJoints.set(Array.from(jointTransforms[joint].offsetMatrix), 16 * i);
  });
  hand.tracked = true;
  return hand;
}

describe('captures of hands', () => {
  test('in iwer’s form are read as they are', () => {
    const parsed: unknown = JSON.parse(JSON.stringify(pinchHandPose));
    expect(readHandCapture(parsed)).toBe(parsed);
    expect(pinchStrength(handOf(readHandCapture(parsed)))).toBe(1);
  });

  test.each<[string, (capture: Record<string, Record<string, object>>) => unknown]>([
    ['no “jointTransforms”', () => null],
    ['no “jointTransforms”', () => 'hand'],
    ['“offsetMatrix” of 16 numbers for “wrist”', ({ jointTransforms }) => ({ jointTransforms: { ...jointTransforms, wrist: undefined } })],
    ['“offsetMatrix” of 16 numbers for “thumb-tip”', (capture) => changed(capture, { offsetMatrix: [1, 2] })],
    ['“offsetMatrix” of 16 numbers for “thumb-tip”', (capture) => changed(capture, { offsetMatrix: Array(16).fill(null) })],
    ['“radius” above 0 for “thumb-tip”', (capture) => changed(capture, { radius: 0 })],
    ['“gripOffsetMatrix”', (capture) => ({ ...capture, gripOffsetMatrix: [] })],
  ])('that are wrong are refused with the reason: %s', (reason, change) => {
    const capture = JSON.parse(JSON.stringify(pinchHandPose)) as Record<string, Record<string, object>>;
    expect(() => readHandCapture(change(capture))).toThrow(reason);
  });

  test('a pointing hand whose index finger closes is a fist, with fingers as long as before', () => {
    const fist = closeIndexFinger(pointHandPose);
    expect([grabStrength(handOf(pointHandPose)), grabStrength(handOf(fist))]).toEqual([0, 1]);
    const bone = (capture: HandCapture, finger: string, part: string, next: string) => {
      const at = (name: string) => Array.from(capture.jointTransforms[`${finger}-finger-${name}` as 'wrist'].offsetMatrix).slice(12, 15);
      const [a, b] = [at(part), at(next)];
      return Math.hypot(...a.map((x, i) => x - (b[i] ?? 0)));
    };
    expect(bone(fist, 'index', 'metacarpal', 'phalanx-proximal')).toBeCloseTo(
      bone(pointHandPose, 'index', 'metacarpal', 'phalanx-proximal'),
      5,
    );
    expect(bone(fist, 'index', 'phalanx-distal', 'tip')).toBeCloseTo(bone(pointHandPose, 'middle', 'phalanx-distal', 'tip'), 5);
    // Beside the middle finger, as far from it as the knuckles are.
    expect(
      Math.abs(
        (fist.jointTransforms['index-finger-tip'].offsetMatrix[12] ?? 0) -
          (fist.jointTransforms['middle-finger-tip'].offsetMatrix[12] ?? 0),
      ),
    ).toBeLessThan(0.04);
  });
});

function changed(capture: Record<string, Record<string, object>>, more: object): unknown {
  const { jointTransforms } = capture;
  return { ...capture, jointTransforms: { ...jointTransforms, 'thumb-tip': { ...jointTransforms?.['thumb-tip'], ...more } } };
}
