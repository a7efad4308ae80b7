import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { describeWithData } from '../support/shared-data.ts';

const chromium = useBrowser();
const folder = resolve('../shared/data/models');
let page: PageModule;

beforeAll(async () => {
  page = await openModule(chromium.browser, 'tests/browser/scenes-models.page.ts', { mounts: { '/models/': folder } });
  expect(await page.call('forbidBlobs')).toBe('refused');
});
afterAll(async () => {
  await page.close();
  // The two of `forbidBlobs`, by which the policy was seen to hold.
  expect(page.errors.filter((error) => !error.includes('blob:'))).toEqual([]);
});

describeWithData('real models', 'models', () => {
  const names = readdirSync(folder).filter((name) => name.endsWith('.glb'));
  test('are there', () => expect(names).toContain('Fox.glb'));

  describe.each(names)('%s', (name) => {
    test('loads under a strict policy and is seen in its colors', async () => {
      const { covered, bright, colors, error } = await page.call<Record<string, number>>('show', `/models/${name}`);
      expect(covered).toBeGreaterThan(800);
      expect(bright).toBeGreaterThan(120);
      expect(colors).toBeGreaterThan(10);
      expect(error).toBe(0);
    });

    test('is refused with its size when it is cut off', async () => {
      expect(await page.call('refusal', `/models/${name}`, 20_000)).toMatch(
        /^Error: the file is incomplete: it has 20000 of \d{5,7} bytes\. Copy or export it again\.$/,
      );
    });
  });

  test('instances share geometry and materials, and move by themselves', async () => {
    const { shared, apart } = await page.call<{ shared: boolean; apart: number }>('instances', '/models/Fox.glb');
    expect(shared).toBe(true);
    // Fox is made in centimeters.
    expect(apart).toBeGreaterThan(1);
  });

  test('nothing is left on the GPU of scenes, maps and models, nor of whole backends', async () => {
    const urls = ['Fox', 'BoomBox', 'AttenuationTest'].map((name) => `/models/${name}.glb`);
    const { warm, later, before, after } = await page.call<Record<string, object>>('leaks', urls);
    expect(later).toEqual(warm);
    expect(after).toEqual(before);
  });
});

test('a .gltf with everything in it loads too; broken pictures are named', async () => {
  expect(await page.call('embedded')).toEqual({
    // An opaque material takes no alpha from its picture.
    color: [255, 128, 0, 255],
    broken: 'Error: the file is damaged: image 0 is damaged or has an unsupported format. Use PNG, JPEG or WebP. Export it again.',
    error: 0,
  });
});
