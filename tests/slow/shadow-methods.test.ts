import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { Agreement } from '../browser/shadow-kit.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { isRequired } from '../support/required.ts';

const chromium = useBrowser();
const models = resolve('../shared/data/models');
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/shadow-methods.page.ts', { mounts: { '/models/': models } });
});
afterAll(async () => {
  await page.close();
  expect(page.errors).toEqual([]);
});

const atLeast = (share: number) => expect.closeTo((1 + share) / 2, -Math.log10(1 - share));

/** Of small things, the edge, where the one method is soft and the other is not, is a larger part. */
const SMALL = 0.94;

describe('shadow maps and shadow volumes', () => {
  test.each(['sun', 'spot', 'bulb'])('agree in all four directions between what is real and what is virtual, by a %s', async (light) => {
    const result = await page.call<Record<string, Agreement & { error: number }>>('directions', light);
    expect(Object.keys(result)).toEqual(['virtual on virtual', 'virtual on real', 'real on virtual', 'real on real']);
    for (const [direction, { overlap, alike, shadowed, error }] of Object.entries(result)) {
      expect([direction, overlap, alike, error]).toEqual([direction, atLeast(0.97), atLeast(0.97), 0]);
      expect(shadowed).toBeGreaterThan(2000);
    }
  });

  test('agree on open, forked, ringed, mirrored, instanced and bent things', async () => {
    const result = await page.call<Record<string, Agreement>>('shapes');
    for (const [shape, { overlap, shadowed }] of Object.entries(result)) {
      expect([shape, overlap]).toEqual([shape, atLeast(SMALL)]);
      expect(shadowed).toBeGreaterThan(2000);
    }
  });

  test('agree in two views, each with an eye of its own', async () => {
    const { left, right, between } = await page.call<{ left: Agreement; right: Agreement; between: number }>('views');
    expect([left.overlap, right.overlap]).toEqual([atLeast(0.97), atLeast(0.97)]);
    expect(between).toBeLessThan(0.9);
  });

  const fox = existsSync(resolve(models, 'Fox.glb'));
  (fox || isRequired('data') ? test : test.skip)(
    `agree on an animated model${fox ? '' : ': ../shared/data/models is missing'}`,
    async () => {
      const { overlap, told } = await page.call<Agreement & { told: string[] }>('model', '/models/Fox.glb');
      expect([overlap, told]).toEqual([atLeast(SMALL), []]);
    },
  );
});
