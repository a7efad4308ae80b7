import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-video.page.ts');

const FIX = 'Save it as MP4 with H.264, or as WebM with VP9, which browsers play everywhere.';

describe('a video', () => {
  test.each([true, false])('shows the picture of every moment that is asked for (says its length: %s)', async (timed) => {
    // On the border between two pictures, the later one; forwards, backwards and to the very end.
    const times = [0, 0.05, 0.1, 0.2, 0.3, 0.35, 1.55, 1.9, 2, 0.2, 1.0, 0.95];
    expect(await page.call('held', times, timed)).toEqual({
      // Without word of it, the end is where the last picture begins.
      durationS: expect.closeTo(timed ? 2 : 1.9, 2),
      size: [32, 32],
      shown: [0, 0, 1, 2, 3, 3, 15, 19, 19, 2, 10, 9],
      again: null,
      // Another node has a time of its own.
      other: [12],
      stays: [9],
      textures: 0,
      error: 0,
    });
  });

  test('ends at the last of many moments that were asked for at once', async () => {
    expect(await page.call('dragged')).toEqual([14]);
  });

  test('keeps its transparency, premultiplied', async () => {
    const { left, right, bottom, error } = await page.call<Record<'left' | 'right' | 'bottom', number[]> & { error: number }>(
      'transparency',
    );
    const near = (value: number): unknown => expect.closeTo(value, -1);
    expect(left).toEqual([0, 0, 0, 0]);
    expect(right).toEqual([near(100), near(100), near(100), near(128)]);
    expect(bottom).toEqual([near(200), near(200), near(200), 255]);
    expect(error).toBe(0);
  });

  test('runs by itself, its pictures in order, and is exact again when held', async () => {
    const { seen, then, problems } = await page.call<{ seen: number[]; then: number[]; problems: string[] }>('running', 6);
    expect([then, problems]).toEqual([[7], []]);
    // Forwards, but for its start over.
    const back = seen.filter((index, i) => i > 0 && index < (seen[i - 1] ?? 0));
    expect(back.length).toBeLessThanOrEqual(Math.ceil(seen.length / 3));
    expect(seen.every((index) => index >= 0 && index < 20)).toBe(true);
  });

  test('that may not start is shown picture by picture, says so, and runs after a tap', async () => {
    expect(await page.call('blocked')).toEqual({
      problems: [
        {
          message: 'The browser blocks the video from starting by itself. It is shown frame by frame until the page is tapped.',
          fix: 'Tap or click the page. If that does not help, turn power saving off.',
        },
      ],
      shown: 5,
      silent: true,
      triedAgain: true,
    });
  });

  test('that cannot be played is refused with what to do', async () => {
    expect(await page.call('refusals')).toEqual({
      noise: `it is neither an MP4 nor a WebM file | ${FIX}`,
      otherCodec: `this browser has no decoder for it | ${FIX}`,
      headOnly: `this browser has no decoder for it | ${FIX}`,
    });
  });
});
