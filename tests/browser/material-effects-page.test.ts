import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { filteredScene, isInMaterials } from '../support/material-effects-kit.ts';
import { eventually } from '../support/patience.ts';
import { type ServedPage, servePage } from './page-kit.ts';

const chromium = useBrowser();

let served: ServedPage;
beforeAll(async () => {
  const pair = filteredScene({
    effects: [['filter/sepia'], ['filter/curves']],
    nodes: { 'slider-a': { type: 'input/slider', version: 1, params: { label: 'Age', value: 0 } } },
    wires: ['slider-a.number -> e-0.amount'],
    options: { sourceMaps: false, fold: true },
  });
  expect(isInMaterials(pair)).toBe(true);
  served = await servePage({ ...pair.fused, title: 'A ball' });
});
afterAll(() => served.close());

test('a page computes effects in materials, and has no passes for them', async () => {
  const page = await chromium.browser.newPage({ viewport: { width: 1200, height: 700 } });
  const errors = collectErrors(page);
  await page.goto(served.url);
  const slider = page.getByRole('slider', { name: 'Age' });
  await slider.waitFor();
  const shown = async (): Promise<number[]> => {
    const image = decodeImage(await page.screenshot());
    const pixels = Array.from({ length: 120 * 70 }, (_, i) => [...pixelAt(image, (i % 120) * 10, Math.floor(i / 120) * 10)]);
    // The bluest pixel is that of the ball, as long as it has a color.
    return pixels.reduce((best, pixel) => (blueness(pixel) > blueness(best) ? pixel : best));
  };
  await eventually(async () => expect(blueness(await shown())).toBeGreaterThan(80));
  await slider.fill('1');
  await eventually(async () => expect(blueness(await shown())).toBeLessThan(20));
  expect(errors).toEqual([]);
  expect(Object.keys(served.report.modules.page).filter((file) => file.includes('effects'))).toHaveLength(2);
  await page.close();
});

function blueness([r = 0, g = 0, b = 0]: readonly number[]): number {
  return b - Math.max(r, g);
}
