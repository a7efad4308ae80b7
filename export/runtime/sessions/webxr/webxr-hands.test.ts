import { describe, expect, test } from '@jest/globals';
import { HAND_JOINTS } from '../../../../nodes/kit/hand-joints.ts';
import { createSessionInput } from '../input/session-input.ts';
import { createWebXrHands } from './webxr-hands.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

interface Joint {
  readonly name: string;
  x: number;
  radiusM: number;
}

function start() {
  const hand = new Map<string, Joint>(HAND_JOINTS.map((name, i) => [name, { name, x: i, radiusM: 0.01 }]));
  const sources = [{ handedness: 'left', hand }] as { handedness: string; hand?: Map<string, Joint> }[];
  const answers = { poses: true, zeros: false };
  const frame = {
    fillPoses: (spaces: Joint[], _base: object, out: Float32Array) => {
      if (!answers.poses) return false;
      spaces.forEach(({ x }, i) => {
        out.set(answers.zeros ? new Array<number>(16).fill(0) : IDENTITY, 16 * i);
        if (!answers.zeros) out[16 * i + 12] = x;
      });
      return true;
    },
    fillJointRadii: (spaces: Joint[], out: Float32Array) => {
      spaces.forEach(({ radiusM }, i) => {
        out[i] = radiusM;
      });
      return true;
    },
  };
  const hands = createWebXrHands({ inputSources: sources } as never, {} as never);
  const input = createSessionInput();
  const read = () => {
    hands.fill(input, frame as never);
    return input.leftHand;
  };
  return { hand, sources, answers, frame, input, read };
}

describe('hands of a WebXR session', () => {
  test('have the joints in the order of the kit', () => {
    const { read, input } = start();
    const { tracked, worldFromJoints, radiiM } = read();
    expect(tracked).toBe(true);
    expect(HAND_JOINTS.map((_, i) => worldFromJoints[16 * i + 12])).toEqual(HAND_JOINTS.map((_, i) => i));
    expect(radiiM[24]).toBeCloseTo(0.01, 6);
    expect(input.rightHand.tracked).toBe(false);
  });

  test.each<[string, (stage: ReturnType<typeof start>) => void]>([
    ['the browser has no pose', ({ answers }) => Object.assign(answers, { poses: false })],
    ['all poses are zero', ({ answers }) => Object.assign(answers, { zeros: true })],
    ['one joint is at NaN', ({ hand }) => Object.assign(hand.get('thumb-tip') ?? {}, { x: Number.NaN })],
    ['there is no source', ({ sources }) => sources.splice(0)],
    ['the source is a controller', ({ sources }) => sources.splice(0, 1, { handedness: 'left' })],
    ['the browser has no such method', ({ frame }) => Reflect.deleteProperty(frame, 'fillPoses')],
  ])('are not tracked while %s, and keep their last poses', (_what, lose) => {
    const stage = start();
    stage.read();
    lose(stage);
    const { tracked, worldFromJoints } = stage.read();
    expect([tracked, worldFromJoints[16 * 24 + 12]]).toEqual([false, 24]);
  });

  test('are not tracked where a joint is missing', () => {
    const { hand, read } = start();
    hand.delete('wrist');
    expect(read().tracked).toBe(false);
  });

  test('keep the last radius of a joint while the device gives none, at first that of a finger', () => {
    const { hand, read } = start();
    const tip = hand.get('thumb-tip') as Joint;
    const radiusOf = (radiusM: number) => {
      tip.radiusM = radiusM;
      return read().radiiM[4];
    };
    expect([radiusOf(Number.NaN), radiusOf(0.02), radiusOf(0), radiusOf(Number.NaN)]).toEqual(
      [0.008, 0.02, 0.02, 0.02].map((x) => expect.closeTo(x, 6)),
    );
  });
});
