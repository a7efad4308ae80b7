import { readdirSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Acne } from './shadow-acne.page.ts';

/** The part of lit pixels that may be in a false shadow. */
const BAR = 0.001;
/** So many pixels are not a stripe: models have triangles smaller than a pixel. */
const FEW = 6;

const namesOf = (folder: string): string[] => readdirSync(folder).filter((name) => name.endsWith('.glb'));

describeWithData('models on their own lit sides', 'models', (folder) => {
  const chromium = useBrowser();
  let page: PageModule;

  beforeAll(async () => {
    page = await openModule(chromium.browser, 'tests/slow/shadow-acne.page.ts', { mounts: { '/models/': folder } });
    for (const name of namesOf(folder)) {
      const { inside } = await page.call<{ inside: number }>('load', name);
      expect([name, inside > 500]).toEqual([name, true]);
    }
  });
  afterAll(async () => {
    await page.close();
    expect(page.errors).toEqual([]);
  });

  test.each([
    ...['sun', 'spot', 'point'].map((kind) => [kind, null] as const),
    ...['basic', 'pcf', 'soft', 'pcss', 'vsm'].map((filter) => ['sun', filter] as const),
    ...['basic', 'pcf', 'soft', 'pcss', 'vsm'].map((filter) => ['spot', filter] as const),
    ...['basic', 'pcf', 'soft'].map((filter) => ['point', filter] as const),
  ])('have no false shadows: %s, filter %s', async (kind, filter) => {
    // All models at once, because most of the time goes into shaders, not into pixels.
    const found = Object.entries(await page.call<Record<string, Acne>>('acne', kind, filter));
    expect(found.map(([name]) => name)).toEqual(namesOf(folder));
    const wrong = found.filter(([, one]) => one.lit <= 100 || one.wrong > Math.max(BAR * one.lit, FEW));
    expect(Object.fromEntries(wrong)).toEqual({});
  });
});
