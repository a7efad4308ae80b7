import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/runtime-swap.page.ts');

const NO_ERROR = 0;
const GREEN = [0, 255, 0, 255];
const BLUE = [0, 0, 255, 255];

describe('a running program is replaced', () => {
  test('by a good one only: the last good one runs on, and the driver is quoted', async () => {
    expect(await page.call('keepsTheLastGood')).toEqual({
      good: GREEN,
      meanwhile: GREEN,
      broken: { outcome: 'kept', errors: [{ shaderId: 'broken', stage: 'fragment' }] },
      log: expect.stringMatching(/ERROR: 0:6: 'nonsense'/),
      after: GREEN,
      mended: { outcome: 'playing', errors: [] },
      end: BLUE,
      error: NO_ERROR,
    });
  });

  test('even if the first is broken: its pictures are handed on meanwhile', async () => {
    expect(await page.call('startsBroken')).toEqual({
      ready: { outcome: 'playing', errors: [{ shaderId: 'broken', stage: 'fragment' }] },
      bypassed: [255, 0, 0, 255],
      superseded: { outcome: 'superseded', errors: [] },
      result: { outcome: 'playing', errors: [] },
      end: GREEN,
      error: NO_ERROR,
    });
  });

  test('and nodes that are the same keep their state', async () => {
    expect(await page.call('nodesLiveOn')).toEqual({
      counted: [10, 20, 21, 23, 28, 5, 7],
      logBefore: ['create count'],
      log: ['create count', 'dispose count', 'create count', 'dispose count'],
      error: NO_ERROR,
    });
  });

  test('and a node that draws lives on wherever its picture goes', async () => {
    const RED = [255, 0, 0, 255];
    expect(await page.call('drawingLivesOn')).toEqual({ shown: [RED, GREEN, RED], log: ['create', 'dispose'], error: NO_ERROR });
  });

  test('fifty times without a GPU object more', async () => {
    const result = await page.call<{ start: unknown; end: unknown; own: object; outcomes: string[]; after: string[]; error: number }>(
      'leaks',
    );
    expect(result.end).toEqual(result.start);
    expect(result.own).toMatchObject({ programs: 3, vertexArrays: 1, samplers: 2, scenes: null });
    expect(result.outcomes.filter((o) => o === 'kept')).toHaveLength(10);
    expect(result.outcomes.filter((o) => o === 'playing')).toHaveLength(40);
    expect(result.after).toEqual([]);
    expect(result.error).toBe(NO_ERROR);
  });
});

test('tapped layers can be read, per view, with depth in meters', async () => {
  // Window depth 0.5 of near 0.1 and far 100: 2·f·n / (f + n) meters.
  const half = (2 * 100 * 0.1) / 100.1;
  expect(await page.call('taps')).toEqual({
    undrawn: null,
    left: [GREEN, [0, 0, 0, 0]],
    right: [
      [255, 255, 0, 255],
      [0, 0, 0, 0],
    ],
    small: [8, 8, [255, 255, 0, 255], [0, 0, 0, 0]],
    window: [expect.closeTo(half, 4), 0],
    meters: [0, 2.5],
    missing: [null, null, null],
    error: NO_ERROR,
  });
});
