import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { captureHand } from '../../tests/support/captured-hand.ts';
import { HAND_JOINT_COUNT, HAND_JOINTS, type HandJoint, jointIndex } from './hand-joints.ts';
import { grabStrength, pinchStrength, writePalm, writePinch } from './hands.ts';

const positionOf = (m: Float32Array, joint: HandJoint) => new Vector3().fromArray(m, 16 * jointIndex(joint) + 12);

describe('a hand that was captured on a headset', () => {
  test.each([
    ['relaxed', 0, 0],
    ['pinch', 1, 0],
    ['point', 0, 0],
    ['fist', 0, 1],
  ] as const)('%s: pinch %d, grab %d', (pose, pinch, grab) => {
    const hand = captureHand(pose);
    expect([pinchStrength(hand), grabStrength(hand)]).toEqual([pinch, grab]);
    hand.tracked = false;
    expect([pinchStrength(hand), grabStrength(hand)]).toEqual([0, 0]);
  });

  test('a pinch closes from 6 cm to 1 cm between the tips', () => {
    const hand = captureHand('pinch');
    const thumb = positionOf(hand.worldFromJoints, 'thumb-tip');
    const at = (distanceM: number) => {
      hand.worldFromJoints.set(
        thumb
          .clone()
          .add(new Vector3(0, distanceM, 0))
          .toArray(),
        16 * jointIndex('index-finger-tip') + 12,
      );
      return pinchStrength(hand);
    };
    expect([at(0.07), at(0.06), at(0.035), at(0.01), at(0)]).toEqual([0, 0, 0.5, 1, 1].map((x) => expect.closeTo(x, 5)));
  });

  test('the palm is in the middle of the middle finger’s metacarpal bone, and faces away from the back of the hand', () => {
    const hand = captureHand('relaxed');
    const out = new Float32Array(16);
    writePalm(out, hand);
    const [from, to] = (['middle-finger-metacarpal', 'middle-finger-phalanx-proximal'] as const).map((joint) =>
      positionOf(hand.worldFromJoints, joint),
    );
    const palm = new Matrix4().fromArray(out);
    const middle = new Vector3().setFromMatrixPosition(palm);
    expect(middle.distanceTo(from?.clone().lerp(to ?? from, 0.5) ?? new Vector3())).toBeLessThan(1e-6);
    // -z points along the bone to the finger.
    const forward = new Vector3(0, 0, -1).transformDirection(palm);
    const bone = to?.clone().sub(from ?? to) ?? new Vector3();
    expect(forward.angleTo(bone)).toBeLessThan(0.35);
    // Fingers close towards the palm: those of a fist lie on its -y side.
    const fist = captureHand('fist');
    writePalm(out, fist);
    const inPalm = positionOf(fist.worldFromJoints, 'middle-finger-tip').applyMatrix4(new Matrix4().fromArray(out).invert());
    expect(inPalm.y).toBeLessThan(-0.02);
  });

  test('a pinch is between the tips, with the axes of the index finger', () => {
    const hand = captureHand('relaxed');
    const out = new Float32Array(16);
    writePinch(out, hand);
    const tips = (['thumb-tip', 'index-finger-tip'] as const).map((joint) => positionOf(hand.worldFromJoints, joint));
    const at = new Vector3().fromArray(out, 12);
    expect(at.distanceTo(tips[0] ?? at)).toBeCloseTo(at.distanceTo(tips[1] ?? at), 6);
    expect([...out.slice(0, 12)]).toEqual([...hand.worldFromJoints.slice(16 * 9, 16 * 9 + 12)]);
  });
});

test('there are 25 joints, each once', () => {
  expect([HAND_JOINTS.length, new Set(HAND_JOINTS).size, jointIndex('wrist'), jointIndex('pinky-finger-tip')]).toEqual([
    HAND_JOINT_COUNT,
    25,
    0,
    24,
  ]);
});
