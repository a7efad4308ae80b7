import { readFile } from 'node:fs/promises';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { pageReady } from '../support/exported-page.ts';
import { decodeImage, type RgbaImage } from '../support/image.ts';
import { expectSamePixels } from '../support/pixels.ts';
import type { ProjectText } from '../support/project-kit.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';

const chromium = useBrowser();

/** An image by one filter. */
function project(type: string, params: Readonly<Record<string, unknown>>): ProjectText {
  return {
    title: 'Curves',
    nodes: {
      'picture-a1': ['source/image-file', { file: 'photo' }],
      'filter-b2': [type, params],
      'screen-c3': 'output/screen',
    },
    wires: ['picture-a1.layer -> filter-b2.inputImage', 'filter-b2.layer -> screen-c3.layer'],
    assets: { photo: { path: 'assets/photo.png', kind: 'image' } },
  };
}

const WHITE_TO_GREEN = [0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 1, 0];

let pages: readonly ServedExport[] = [];
beforeAll(async () => {
  const files = { 'assets/photo.png': await readFile('tests/browser/expected/photograph.png') };
  const served = (type: string, params: Readonly<Record<string, unknown>>) => serveProjectText(project(type, params), files);
  pages = [
    await served('filter/curves', { all: [0, 0, 1, 1] }),
    await served('filter/curves', { all: [0, 1, 1, 0] }),
    await served('filter/gradient-map', { gradient: WHITE_TO_GREEN }),
  ];
});
afterAll(async () => {
  for (const page of pages) await page.close();
});

async function visit({ url }: ServedExport): Promise<RgbaImage> {
  const page = await chromium.browser.newPage({ viewport: { width: 640, height: 480 } });
  const errors = collectErrors(page);
  await page.goto(url);
  await pageReady(page);
  // What the page says lies over the left of the image.
  const picture = decodeImage(await page.screenshot({ clip: { x: 340, y: 20, width: 280, height: 380 } }));
  expect(errors).toEqual([]);
  await page.close();
  return picture;
}

test('an exported page draws tones by the curves of its project', async () => {
  const [plain, negative] = [await visit(pages[0] as ServedExport), await visit(pages[1] as ServedExport)];
  const expected = { ...plain, data: plain.data.map((value, i) => (i % 4 === 3 ? value : 255 - value)) };
  await expectSamePixels('page-negative', negative, expected, { tolerance: 2 });
  // Not all of one gray, which would be its own negative.
  expect(new Set(plain.data).size).toBeGreaterThan(50);
});

test('an exported page maps brightness to the gradient of its project', async () => {
  const [plain, mapped] = [await visit(pages[0] as ServedExport), await visit(pages[2] as ServedExport)];
  const expected = { ...plain, data: plain.data.slice() };
  for (let i = 0; i < expected.data.length; i += 4) {
    const [r = 0, g = 0, b = 0] = plain.data.subarray(i, i + 3);
    const left = Math.round(255 - (0.2126 * r + 0.7152 * g + 0.0722 * b));
    expected.data.set([left, 255, left], i);
  }
  await expectSamePixels('page-gradient', mapped, expected, { tolerance: 2 });
});
