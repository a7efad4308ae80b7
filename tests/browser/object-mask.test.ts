import { expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';

const page = useModule('tests/browser/object-mask.page.ts');

const NOTHING = [0, 0, 0, 0];
const WHITE = [255, 255, 255, 255];
const NO_ERROR = 0;

test.each([
  ['silhouette', 1500],
  ['cutOut', 300],
])('%s: white and opaque exactly where the objects are drawn', async (what, least) => {
  const { colors, differ, covered, error } = await page.call<{ colors: string[]; differ: number; covered: number; error: number }>(what);
  expect({ colors, differ, error }).toEqual({ colors: ['0,0,0,0', '255,255,255,255'], differ: 0, error: NO_ERROR });
  expect(covered).toBeGreaterThan(least);
});

test.each(['phantom', 'object', 'part'])('a %s before it cuts the mask', async (by) => {
  expect(await page.call('hidden', by)).toEqual({ left: NOTHING, right: WHITE, error: NO_ERROR });
});

test('the room cuts it while it is drawn, and a soft border fades it', async () => {
  expect(await page.call('occluded', 0)).toEqual({ left: NOTHING, right: WHITE, error: NO_ERROR });
  const { left, right } = await page.call<{ left: number[]; right: number[] }>('occluded', 0.2);
  expect(right).toEqual(WHITE);
  expect(new Set(left).size).toBe(1);
  expect(left[0]).toBeGreaterThan(115);
  expect(left[0]).toBeLessThan(140);
});
