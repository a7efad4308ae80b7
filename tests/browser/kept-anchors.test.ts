import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/kept-anchors.page.ts');

/** The state of one visit as the page tells it. */
interface Told {
  readonly at: number[];
  readonly handles: number;
}

describe('anchors over visits', () => {
  test('are at the same point of the room in the next visit, whose world space is another, until they are forgotten', async () => {
    const { first, second, third } = await page.call<{ first: Told; second: Told; third: null }>('later');
    expect(first).toEqual({ asked: 'pending', keeping: 'kept', at: [0.5, 0.7, -1], handles: 1 });
    // From (1, 2), a quarter turn to the left: what was at (0.5, -1) is 3 to the right and 0.5 ahead.
    expect(second).toEqual({ tracked: 0, before: 'pending', state: 'tracked', at: [3, 0.7, -0.5], elsewhere: null, handles: 0 });
    expect(third).toBe(null);
  });

  test('are eight on a headset: a ninth replaces the oldest of all pages of the origin, and says so', async () => {
    const { first, second, oldest, gone } = await page.call<Record<string, unknown>>('nine');
    expect(first).toEqual({ told: ['kept 0'], handles: 1 });
    expect(second).toEqual({ told: [...Array.from({ length: 7 }, () => 'kept 0'), 'kept 1'], handles: 8 });
    expect([oldest, gone]).toEqual([null, 'deleted']);
  });

  test('are refused by a phone, which anchors all the same', async () => {
    expect(await page.call('phone')).toEqual(['tracked', 'refused', null]);
  });
});

test('for ten minutes of drift and re-centering an anchored pose stays within 1 mm of its point of the room, a loose one does not', async () => {
  const { anchored, unanchored, ...rest } = await page.call<{ anchored: number; unanchored: number }>('tenMinutes');
  expect(anchored).toBeLessThan(0.001);
  // World space begins where the visitor re-centers, and drifts from there.
  expect(unanchored).toBeGreaterThan(0.2);
  const open = { hitTests: 0, deviceSources: 0, anchors: 1 };
  expect(rest).toEqual({ spatialBefore: open, spatialAfter: open, tracked: 0, ended: 'visible' });
});
