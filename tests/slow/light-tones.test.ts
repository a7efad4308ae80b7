import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';
import type { Tones } from './light-tones.page.ts';
import { LAMP_NAMES, PANORAMAS } from './light-tones-lamps.ts';
import { ASKED } from './light-tones-styles.ts';

const MODELS = ['Fox.glb', 'BoomBox.glb', 'AntiqueCamera.glb', 'RobotExpressive.glb', 'LeePerrySmith.glb'];

/** How far the mean may be from the tone asked for. */
const NEAR = 0.1;
/** A step of 255 at black, in linear light. */
const STEP = 1 / 255 / 12.92;

describeWithData('styles in the light of the room', '.', (folder) => {
  const chromium = useBrowser();
  let page: PageModule;

  beforeAll(async () => {
    const mounts = { '/models/': `${folder}/models`, '/panoramas/': `${folder}/panoramas` };
    page = await openModule(chromium.browser, 'tests/slow/light-tones.page.ts', { mounts });
    await page.call('prepare', MODELS, Object.values(PANORAMAS));
  });
  afterAll(async () => {
    await page.close();
    expect(page.errors).toEqual([]);
  });

  describe.each(Object.keys(ASKED))('%s', (style) => {
    test.each(LAMP_NAMES)('is as bright as the light of “%s” asks for, and brighter in more of it', async (lamps) => {
      const wrong: string[] = [];
      for (const [i, { drawn, asked, pixels }] of (await page.call<Tones[]>('tones', style, lamps)).entries()) {
        expect(pixels).toBeGreaterThan(1000);
        const off = drawn.map((mean, i) => Math.abs(mean - (asked[i] ?? 0)) / Math.max(asked[i] ?? 0, 10 * STEP));
        const falls = drawn.some((mean, i) => i > 0 && mean < (drawn[i - 1] ?? 0) - STEP);
        const round = (values: readonly number[]): string => values.map((value) => value.toFixed(4)).join(' ');
        if (falls || off.some((part) => !(part <= NEAR))) wrong.push(`${MODELS[i]}: drawn ${round(drawn)}, asked ${round(asked)}`);
      }
      expect(wrong).toEqual([]);
    });
  });
});
