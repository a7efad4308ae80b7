import { readdirSync } from 'node:fs';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Compared } from './panoramas.page.ts';

/** three's filter takes ten seconds a panorama on SwiftShader, which is why Scrim has one of its own. */
describeWithData('real panoramas', 'panoramas', (folder) => {
  const chromium = useBrowser();
  let page: PageModule;

  beforeAll(async () => {
    page = await openModule(chromium.browser, 'tests/slow/panoramas.page.ts', { mounts: { '/panoramas/': folder } });
  });
  afterAll(async () => {
    await page.close();
    expect(page.errors).toEqual([]);
  });

  const files = readdirSync(folder).filter((name) => /\.(hdr|exr|jpg|png)$/.test(name));

  test('there are some of every format', () => {
    for (const ending of ['.hdr', '.exr', '.jpg', '.png']) expect(files.some((name) => name.endsWith(ending))).toBe(true);
  });

  test.each(files)('%s lights as three’s own filter has it', async (name) => {
    const { sizePx, balls } = await page.call<Compared>('compare', `/panoramas/${name}`);
    expect(sizePx[0]).toBeGreaterThanOrEqual(256);
    for (const { roughness, mean, brightness } of balls) {
      // Mirrors differ by the number of samples, and lamps of a pixel or two by where they are taken: of 255, 6 at the most.
      expect([roughness, mean < 8, brightness > 20]).toEqual([roughness, true, true]);
    }
  });
});
