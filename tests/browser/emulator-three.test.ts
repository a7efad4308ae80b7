import { expect, test } from '@jest/globals';
import { openModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();

test.each([
  ['a phone', { device: 'phone' }, 1],
  ['a headset', { device: 'headset' }, 2],
])('three.js’ own WebXR manager draws on %s', async (_, options, views) => {
  const page = await openModule(chromium.browser, 'tests/browser/emulator-three.page.ts');
  const found = await page.call<{
    views: number;
    middles: number[][];
    corner: number[];
    harmonics: number[];
    direction: number[];
    hasCameraTexture: boolean;
  }>('withThree', options);
  expect(found.views).toBe(views);
  expect(found.middles).toEqual(Array.from({ length: views }, () => [255, 0, 0, 255]));
  expect(found.hasCameraTexture).toBe(true);
  expect(found.corner).toEqual([0, 0, 0, 0]);
  expect(found.harmonics).toHaveLength(27);
  expect(found.harmonics.slice(0, 3).every((value) => value > 0.1)).toBe(true);
  const [x = 0, y = 0] = found.direction;
  expect(x).toBeLessThan(-0.5);
  expect(y).toBeGreaterThan(0.3);
  expect(page.errors).toEqual([]);
  await page.close();
});
