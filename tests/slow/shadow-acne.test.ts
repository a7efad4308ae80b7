import { readdirSync } from 'node:fs';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Acne } from './shadow-acne.page.ts';

/** The part of lit pixels that may be in a false shadow. */
const BAR = 0.001;
/** So many pixels are not a stripe: models have triangles smaller than a pixel. */
const FEW = 6;

describeWithData('models on their own lit sides', 'models', (folder) => {
  const chromium = useBrowser();
  let page: PageModule;

  beforeAll(async () => {
    page = await openModule(chromium.browser, 'tests/slow/shadow-acne.page.ts', { mounts: { '/models/': folder } });
  });
  afterAll(async () => {
    await page.close();
    expect(page.errors).toEqual([]);
  });

  describe.each(readdirSync(folder).filter((name) => name.endsWith('.glb')))('%s', (name) => {
    beforeAll(async () => {
      const { inside } = await page.call<{ inside: number }>('load', name);
      expect(inside).toBeGreaterThan(500);
    });

    test.each([
      ...['sun', 'spot', 'point'].map((kind) => [kind, null] as const),
      ...['basic', 'pcf', 'soft', 'pcss', 'vsm'].map((filter) => ['sun', filter] as const),
      ...['basic', 'pcf', 'soft', 'pcss', 'vsm'].map((filter) => ['spot', filter] as const),
      ...['basic', 'pcf', 'soft'].map((filter) => ['point', filter] as const),
    ])('have no false shadows: %s, filter %s', async (kind, filter) => {
      const { lit, wrong } = await page.call<Acne>('acne', name, kind, filter);
      expect(lit).toBeGreaterThan(100);
      expect(wrong).toBeLessThanOrEqual(Math.max(BAR * lit, FEW));
    });
  });
});
