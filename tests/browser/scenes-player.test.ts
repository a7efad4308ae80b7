import { afterAll, beforeAll, expect, jest, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

jest.setTimeout(30_000);
const chromium = useBrowser();
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/scenes-player.page.ts');
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

test('a scene and its shadow are played as layers, follow their params, and leave nothing behind', async () => {
  // 0.8 of white light from 45 degrees on red: 0.8 × cos 45° = 0.566, encoded 198. All colours mirror a little light.
  const sheen = expect.closeTo(24, -1);
  const first = { boxTop: [expect.closeTo(198, -1), sheen, sheen, 255], shadow: [0, 0, 0, 255], floor: [0, 255, 0, 255] };
  expect(await page.call('plays')).toEqual({
    first,
    changed: { boxTop: [sheen, sheen, sheen, 255], shadow: [0, 255, 0, 255], floor: [0, 255, 0, 255] },
    replaced: first,
    same: true,
    diagnostics: [],
    alive: {},
    error: 0,
  });
});

test('a broken model is told at its node', async () => {
  expect(await page.call('brokenModel')).toEqual([
    expect.objectContaining({
      code: 'SCR032',
      nodeId: 'fox',
      message:
        'The model "assets/fox.glb" cannot be decoded: the file is cut off: it should have 20 bytes and has 8. Copy or export it again.',
    }),
  ]);
});

test.each([
  ['a hard border', { biasM: 0, softnessM: 0 }],
  ['tolerance', { biasM: 0.15, softnessM: 0 }],
  ['a soft border', { biasM: 0.01, softnessM: 0.4 }],
])('with %s, hiding fragments gives the picture of hiding the finished layer', async (_what, params) => {
  const { pixels, covered, errors } = await page.call<{ pixels: number; covered: number; errors: number[] }>('equalForms', params);
  expect(errors).toEqual([0, 0]);
  expect(covered).toBeGreaterThan(3000);
  // A border that passes exactly through a pixel's middle may round apart.
  expect(pixels).toBeLessThanOrEqual(3);
});
