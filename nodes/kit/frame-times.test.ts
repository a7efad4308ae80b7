import { describe, expect, test } from '@jest/globals';
import { type FrameTimes, frameAtTime, timeOfFrame } from './frame-times.ts';

const UNEVEN: FrameTimes = { timesS: [0, 0.1, 0.3], durationS: 0.4 };

describe('frames of a recording', () => {
  test('last until the next frame, and their numbers continue when the recording loops', () => {
    expect([-1, 0, 0.05, 0.1, 0.25, 0.3, 0.39].map((timeS) => frameAtTime(UNEVEN, timeS))).toEqual([0, 0, 0, 1, 1, 2, 2]);
    expect([0.4, 0.45, 0.5, 0.7, 0.8].map((timeS) => frameAtTime(UNEVEN, timeS))).toEqual([3, 3, 4, 5, 6]);
    expect([0, 1, 2, 3, 4, 8].map((number) => timeOfFrame(UNEVEN, number))).toEqual(
      [0, 0.1, 0.3, 0.4, 0.5, 1.1].map((s) => expect.closeTo(s, 9)),
    );
  });

  test.each([10, 24, 25, 29.97, 30, 60, 90])(
    'at %s a second are found by their own times, however often these were summed up',
    (rateHz) => {
      const even: FrameTimes = { timesS: Array.from({ length: 36 }, (_, i) => i / rateHz), durationS: 36 / rateHz };
      const wrong: number[] = [];
      let summedS = 0;
      for (let number = 0; number < 20_000; number++) {
        if (frameAtTime(even, timeOfFrame(even, number)) !== number) wrong.push(number);
        if (number < 2000 && frameAtTime(even, summedS) !== number) wrong.push(number);
        summedS += 1 / rateHz;
      }
      expect(wrong).toEqual([]);
    },
  );
});
