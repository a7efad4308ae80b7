import { describe, expect, test } from '@jest/globals';
import { HAND_JOINTS } from '../../../../nodes/kit/hand-joints.ts';
import { createSessionInput } from '../input/session-input.ts';
import type { SessionFileFrame, SessionFileInput, SessionFilePointer } from '../session-format.ts';
import { readSessionFile } from './read-session-file.ts';
import { createInputReplay } from './replay-input.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const COLOR = { widthPx: 2, heightPx: 2, intrinsics: { fxPx: 1, fyPx: 1, cxPx: 1, cyPx: 1 } };

function fileOf(inputs: readonly unknown[]) {
  const frames = inputs.map((input, i) => ({ timeS: i, color: 'a.png', worldFromCamera: IDENTITY, ...(input ? { input } : {}) }));
  return {
    format: 'scrim-session',
    version: 1,
    title: 'Test',
    color: COLOR,
    frameRateHz: 1,
    frames: frames as SessionFileFrame[],
  } as const;
}

const pointer = (phase: SessionFilePointer['phase'], more: object = {}) =>
  ({ id: 1, by: 'screen', phase, worldFromRay: IDENTITY, pinch: 0, ...more }) as const;

/** A touch of three frames, then nothing. */
const TAP: (SessionFileInput | undefined)[] = [
  undefined,
  { pointers: [pointer('start')] },
  { pointers: [pointer('hold')] },
  { pointers: [pointer('end', { tapped: true })] },
  undefined,
  undefined,
];

function play(inputs: readonly (SessionFileInput | undefined)[]) {
  const replay = createInputReplay(fileOf(inputs));
  const input = createSessionInput();
  return {
    input,
    reset: () => replay?.reset(),
    /** The phases of the pointers of a frame, and a * for each tap. */
    at: (number: number) => {
      input.pointerCount = 0;
      replay?.fill(input, number);
      return [...input.pointers.slice(0, input.pointerCount).map(({ phase }) => phase), ...'*'.repeat(input.tapCount)].join(' ');
    },
  };
}

describe('recorded input', () => {
  test('is replayed frame by frame', () => {
    const { at } = play(TAP);
    expect([0, 1, 2, 3, 4, 5].map(at)).toEqual(['', 'start', 'hold', 'end *', '', '']);
  });

  test('presses once where frames are shown several times', () => {
    const { at } = play(TAP);
    expect([0, 1, 1, 1, 2, 3, 3, 4].map(at)).toEqual(['', 'start', 'hold', 'hold', 'hold', 'end *', '', '']);
  });

  test('loses no tap where frames are skipped', () => {
    const { at } = play(TAP);
    expect([0, 4, 5, 6].map(at)).toEqual(['', 'start', 'end *', '']);
  });

  test('repeats with the recording, each time as another press', () => {
    const { at, input } = play(TAP);
    const owners = [0, 1].map((round) => {
      expect([0, 1, 2].map((i) => at(6 * round + i))).toEqual(['', 'start', 'hold']);
      const [first] = input.pointers;
      const { owner } = first ?? {};
      if (first) first.owner = input;
      expect([3, 4, 5].map((i) => at(6 * round + i))).toEqual(['end *', '', '']);
      return owner;
    });
    expect(owners).toEqual([null, null]);
  });

  test('a press whose pointer is gone is canceled; after a seek it is forgotten', () => {
    const lost = play([{ pointers: [pointer('start')] }, { pointers: [pointer('hold')] }, undefined, undefined]);
    expect([0, 1, 2, 3].map(lost.at)).toEqual(['start', 'hold', 'cancel', '']);
    const sought = play(TAP);
    sought.at(1);
    sought.reset();
    expect([sought.at(4), sought.at(5)]).toEqual(['', '']);
  });

  test('sets controllers and hands while they are recorded', () => {
    const joints = HAND_JOINTS.flatMap(() => IDENTITY);
    const { input, at } = play([
      {
        left: { stick: [0.5, -1], trigger: 0.25, squeeze: 1, primary: true, worldFromGrip: IDENTITY },
        rightHand: { worldFromJoints: joints, radiiM: HAND_JOINTS.map(() => 0.01) },
      },
      undefined,
    ]);
    at(0);
    expect(input.left).toMatchObject({ connected: true, trigger: 0.25, squeeze: 1, primary: true, secondary: false, worldFromRay: null });
    expect([[...input.left.stick], [...(input.left.worldFromGrip ?? [])]]).toEqual([[0.5, -1], IDENTITY]);
    expect([input.rightHand.tracked, [...input.rightHand.worldFromJoints], input.leftHand.tracked]).toEqual([true, joints, false]);
    at(1);
    expect([input.left.connected, input.left.worldFromGrip, input.rightHand.tracked]).toEqual([false, null, false]);
  });

  test('there is none without', () => {
    expect(createInputReplay(fileOf([undefined]))).toBe(null);
  });
});

describe('a file with wrong input is refused with the place', () => {
  test.each<[string, unknown]>([
    ['"frames[0].input" must be an object.', 'tap'],
    ['"frames[0].input.pointers" must be a list.', { pointers: {} }],
    ['"frames[0].input.pointers[0].id" must be a whole number', { pointers: [{ ...pointer('start'), id: 0 }] }],
    ['"frames[0].input.pointers[1].id" must be a whole number', { pointers: [pointer('start'), pointer('hover')] }],
    ['"frames[0].input.pointers[0].by" must be one of screen, mouse,', { pointers: [pointer('start', { by: 'foot' })] }],
    ['"frames[0].input.pointers[0].by" must be one of', { pointers: [pointer('start', { by: 'toString' })] }],
    ['"frames[0].input.pointers[0].phase" must be one of', { pointers: [{ ...pointer('start'), phase: 'press' }] }],
    ['"frames[0].input.pointers[0].worldFromRay" must be a pose', { pointers: [pointer('start', { worldFromRay: Array(16).fill(0) })] }],
    ['"frames[0].input.pointers[0].worldFromGrip" must be a pose', { pointers: [pointer('start', { worldFromGrip: [1] })] }],
    ['"frames[0].input.left.stick" must be 2 numbers.', { left: { trigger: 0, squeeze: 0 } }],
    ['"frames[0].input.right.trigger" and', { right: { stick: [0, 0], trigger: '1', squeeze: 0 } }],
    ['"frames[0].input.leftHand.worldFromJoints" must be the poses of 25 joints', { leftHand: { worldFromJoints: [], radiiM: [] } }],
    [
      '"frames[0].input.rightHand.worldFromJoints" must be the poses of 25 joints',
      { rightHand: { worldFromJoints: Array(400).fill(0), radiiM: Array(25).fill(0.01) } },
    ],
  ])('%s', (message, input) => {
    const { output, diagnostics } = readSessionFile(fileOf([input]));
    expect(output).toBe(null);
    expect(diagnostics[0]).toMatchObject({ code: 'SCR054', file: 'session.json', message: expect.stringContaining(message) });
  });
});
