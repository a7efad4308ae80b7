import { describe, expect, test } from '@jest/globals';
import type { FrameScore } from './score.page.ts';
import { type Compared, type Limits, missedLimits, scoreLines, summarize } from './score-summary.ts';

const NONE: Limits = { minIou: null, maxFlicker: null, minContrast: null, maxToneError: null };
const LAYER = { whole: 'scene.layer', shown: 'hide.layer' };
const COMPARED: Compared = { layers: [LAYER], reference: 'video.layer', pixels: 10 };

const counts = (both: number, either: number) => ({
  visibleBoth: both,
  visibleEither: either,
  hiddenBoth: 0,
  hiddenEither: 0,
  hidden: 0,
  all: either,
});

function frame(index: number, more: Partial<FrameScore> = {}): FrameScore {
  return {
    index,
    occlusion: [counts(1, 1)],
    flicker: index === 0 ? null : { sum: 10, count: 10 },
    referenceFlicker: null,
    contrast: 4,
    referenceContrast: null,
    tone: { sum: 10, count: 10 },
    ...more,
  };
}

/** The line of a figure that is not measured. */
function lineOf(figure: string, frames: readonly FrameScore[], compared: Partial<Compared> = {}): string | undefined {
  return scoreLines(summarize(frames, { ...COMPARED, ...compared })).find((line) => line.trim().startsWith(figure));
}

describe('why a figure is not measured', () => {
  const none = counts(0, 0);

  test.each([
    ['the output shows no Scene', [], []],
    ['no layer with objects has the size of the output', [LAYER], [null]],
    ['no objects are in view where the depth is known', [LAYER], [none]],
  ])('occlusion: %s', (why, layers, occlusion) => {
    expect(lineOf('occlusion', [frame(0, { occlusion })], { layers })).toBe(`  occlusion   not measured: ${why}`);
  });

  test.each([
    ['it takes two frames with depth', [frame(0)]],
    ['no two frames with depth follow each other', [frame(0), frame(2, { flicker: null })]],
    ['no frame sees the same surfaces as the previous one', [frame(0), frame(1, { flicker: { sum: 0, count: 0 } })]],
  ])('flicker: %s', (why, frames) => {
    expect(lineOf('flicker', frames)).toBe(`  flicker     not measured: ${why}`);
  });

  test.each([
    ['the output shows no camera video; name a layer with --reference', null, null],
    ['own.layer is not drawn', 'own.layer', null],
    ['virtual objects cover all of the image', 'video.layer', { sum: 0, count: 0 }],
  ])('tone error: %s', (why, reference, tone) => {
    expect(lineOf('tone error', [frame(0, { tone })], { reference })).toBe(`  tone error  not measured: ${why}`);
  });

  test('measured figures have no reason', () => {
    expect(summarize([frame(0), frame(1)], COMPARED).notMeasured).toEqual({});
  });
});

describe('a missed limit', () => {
  const missed = (frames: readonly FrameScore[], limits: Partial<Limits>): string[] =>
    missedLimits(summarize(frames, COMPARED), { ...NONE, ...limits });

  test('of a figure that is not measured is neither above nor below it', () => {
    expect(missed([frame(0)], { maxFlicker: 3 })).toEqual([
      'The flicker is not measured, so its limit of 3 is missed: it takes two frames with depth.',
    ]);
  });

  test('has enough digits to differ from the limit', () => {
    expect(missed([frame(0, { occlusion: [counts(949_999, 1_000_000)] })], { minIou: 0.95 })).toEqual([
      'The IoU of what is visible is 0.949999, below the limit of 0.95.',
    ]);
    expect(missed([frame(0, { tone: { sum: 5_000_001, count: 1_000_000 } })], { maxToneError: 5 })).toEqual([
      'The tone error is 5.000001, above the limit of 5.',
    ]);
    expect(missed([frame(0, { occlusion: [counts(1, 2)] })], { minIou: 0.95 })).toEqual([
      'The IoU of what is visible is 0.5, below the limit of 0.95.',
    ]);
  });

  test('is none where a figure is the limit', () => {
    expect(missed([frame(0), frame(1)], { minIou: 1, maxFlicker: 1, minContrast: 1, maxToneError: 1 })).toEqual([]);
  });
});
