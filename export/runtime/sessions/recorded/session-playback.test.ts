import { describe, expect, test } from '@jest/globals';
import { createManualClock } from '../../clock.ts';
import { createPlayback } from './session-playback.ts';

function play(durationS: number) {
  const clock = createManualClock();
  const shown: number[] = [];
  const heard: string[] = [];
  const playback = createPlayback(clock, {
    durationS: () => durationS,
    show: (timeS) => void shown.push(timeS),
    onRepeat: () => void heard.push('repeat'),
    onLoop: () => void heard.push('loop'),
    onEnd: () => void heard.push('end'),
  });
  playback.start();
  return { clock, playback, shown, heard };
}

describe('a recording in time', () => {
  test('begins with its first moment, runs with the clock and starts over at its end', () => {
    const { clock, shown, heard } = play(1);
    for (const deltaS of [5, 0.5, 0.25, 0.5]) clock.advance(deltaS);
    expect(shown).toEqual([0, 0.5, 0.75, 1.25]);
    expect(heard).toEqual(['repeat']);
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

  test('goes to the next frame exactly, however far it is', () => {
    const { clock, playback, shown } = play(10);
    clock.advance(1);
    playback.advanceTo(0.1);
    playback.advanceTo(0.2);
    expect(playback.playheadS).toBe(0.2);
    clock.advance(5);
    clock.advance(0.5);
    expect(shown).toEqual([0, 0.2, 0.7]);
  });
});

describe('a part of a recording', () => {
  const PART = { fromS: 1, lastS: 1.75, endS: 2 };

  test('begins anew at its end, with the time that is over', () => {
    const { clock, playback, shown, heard } = play(10);
    playback.setRange({ ...PART, loop: true });
    expect(playback.enterRange()).toBe(true);
    for (const deltaS of [9, 0.5, 0.75, 0.5, 0.5]) clock.advance(deltaS);
    expect(shown).toEqual([1, 1.5, 1.25, 1.75, 1.25]);
    expect(heard).toEqual(['loop', 'loop']);
    expect(playback.enterRange()).toBe(false);
  });

  test('without a loop stays at its last frame, and begins at its first when it is played again', () => {
    const { clock, playback, shown, heard } = play(10);
    playback.setRange({ ...PART, loop: false });
    playback.enterRange();
    for (const deltaS of [9, 0.875, 0.25, 0]) clock.advance(deltaS);
    expect(shown).toEqual([1, 1.875, 1.75, 1.75]);
    expect(heard).toEqual(['end']);
    expect(playback.enterRange()).toBe(true);
    clock.advance(0.5);
    expect(shown.at(-1)).toBe(1);
  });

  test('leaves alone who was put behind it or steps over its end', () => {
    const { clock, playback, shown, heard } = play(10);
    playback.setRange({ ...PART, loop: true });
    playback.seek(1.75);
    clock.advance(0.1);
    playback.advanceTo(2);
    clock.advance(0.1);
    clock.advance(0.5);
    expect(shown).toEqual([1.75, 2, 2.5]);
    expect(heard).toEqual([]);
  });

  test('of a single frame stays there', () => {
    const { clock, playback, shown } = play(10);
    playback.setRange({ fromS: 1, lastS: 1, endS: 1.25, loop: false });
    playback.enterRange();
    for (const deltaS of [0, 0.5, 0]) clock.advance(deltaS);
    expect(shown).toEqual([1, 1, 1]);
  });
});
