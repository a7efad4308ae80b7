import { describe, expect, test } from '@jest/globals';
import { createManualClock } from '../../clock.ts';
import { createPlayback } from './playback.ts';

function play(durationS: number) {
  const clock = createManualClock();
  const shown: number[] = [];
  let repeats = 0;
  const playback = createPlayback(clock, {
    durationS: () => durationS,
    show: (timeS) => shown.push(timeS) > 0,
    onRepeat: () => {
      repeats++;
    },
  });
  playback.start();
  return { clock, playback, shown, repeats: () => repeats };
}

describe('a recording in time', () => {
  test('begins with its first moment, runs with the clock and starts over at its end', () => {
    const { clock, shown, repeats } = play(1);
    for (const deltaS of [5, 0.5, 0.25, 0.5]) clock.advance(deltaS);
    expect(shown).toEqual([0, 0.5, 0.75, 0.25]);
    expect(repeats()).toBe(1);
  });

  test('after a jump shows the moment asked for, even when the last frame was long ago', () => {
    const { clock, playback, shown } = play(10);
    clock.advance(1);
    clock.advance(1);
    playback.seek(4);
    clock.advance(0.75);
    clock.advance(0.5);
    expect(shown).toEqual([0, 1, 4, 4.5]);
  });
});
