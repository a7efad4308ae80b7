import { cp, mkdir, readFile, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { paint } from '../browser/glsl-kit.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { chooseOption } from '../support/choose-option.ts';
import { pageReady } from '../support/exported-page.ts';
import { decodeImage, encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { openEditor } from '../support/open-editor.ts';
import { eventually } from '../support/patience.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';

const chromium = useBrowser();

/** The part of the pixels that are nearly black, or nearly white. */
function extremes({ data }: RgbaImage): { readonly dark: number; readonly bright: number } {
  let dark = 0;
  let bright = 0;
  for (let i = 0; i < data.length; i += 4) {
    const sum = (data[i] ?? 0) + (data[i + 1] ?? 0) + (data[i + 2] ?? 0);
    if (sum < 3 * 45) dark++;
    if (sum > 3 * 210) bright++;
  }
  return { dark: (dark * 4) / data.length, bright: (bright * 4) / data.length };
}

describe('an exported page', () => {
  /** Two grays, hard to tell apart: equalized, they are black and white. */
  const GRAYS = paint(64, 36, (x) => (x < 32 ? [100, 100, 100, 255] : [110, 110, 110, 255]));
  const PROJECT = {
    nodes: {
      'picture-a': ['source/image-file', { file: 'grays' }],
      'cpu-a': 'filter/cpu-equalize-histogram',
      'screen-a': 'output/screen',
    },
    wires: ['picture-a.layer -> cpu-a.inputImage', 'cpu-a.layer -> screen-a.layer'],
    assets: { grays: { path: 'assets/grays.png', kind: 'image' } },
  } as const;
  const FILES = { 'assets/grays.png': encodeImage(GRAYS) };
  let served: ServedExport;
  let single: ServedExport;
  beforeAll(async () => {
    served = await serveProjectText(PROJECT, FILES);
    single = await serveProjectText(PROJECT, FILES, { singleFile: true });
  });
  afterAll(async () => {
    await served.close();
    await single.close();
  });

  /** Waits for the worker's image: the first frames show what it is made of. */
  async function expectEqualized(url: string): Promise<void> {
    const page = await chromium.browser.newPage({ viewport: { width: 1280, height: 720 } });
    const errors = collectErrors(page);
    await page.goto(url);
    await pageReady(page);
    await eventually(async () => {
      const picture = decodeImage(await page.screenshot());
      expect([pixelAt(picture, 500, 600), pixelAt(picture, 1200, 600)]).toEqual([
        [0, 0, 0, 255],
        [255, 255, 255, 255],
      ]);
    });
    expect(errors).toEqual([]);
    await page.close();
  }

  test('starts the worker under its own strict policy, which allows workers of its own text alone', async () => {
    const html = await readFile(join(served.folder, 'index.html'), 'utf8');
    const policy = /http-equiv="content-security-policy" content="([^"]+)"/.exec(html)?.[1];
    expect(policy).toContain("worker-src 'self' blob:");
    expect(policy).not.toMatch(/unsafe-/);
    await expectEqualized(served.url);
  });

  test('does so as one file, on a host and opened from a disk', async () => {
    await expectEqualized(single.url);
    const folder = `${single.folder}-file`;
    await mkdir(folder);
    await cp(join(single.folder, 'index.html'), join(folder, 'Gray page.html'));
    await expectEqualized(pathToFileURL(join(folder, 'Gray page.html')).href);
    await rm(folder, { recursive: true });
  });
});

test('the editor’s preview plays it too', async () => {
  const opened = await openEditor(chromium.browser, {
    nodes: {
      'video-a': { type: 'source/camera-video' },
      'fog-a': { type: 'filter/luminance-variation', params: { brightness: 0.1, contrast: 0.2 } },
      'cpu-a': { type: 'filter/cpu-equalize-histogram' },
      'screen-a': { type: 'output/screen' },
    },
    wires: ['video-a.layer -> fog-a.inputImage', 'fog-a.layer -> cpu-a.inputImage', 'cpu-a.layer -> screen-a.layer'],
    places: { 'video-a': [0, 0], 'fog-a': [300, 0], 'cpu-a': [600, 0], 'screen-a': [900, 0] },
  });
  const { page, editor, errors } = opened;
  await editor.settled();
  await chooseOption(page.getByRole('combobox', { name: 'Preview source' }), 'room/studio');
  await editor.settled();
  // The fog leaves a fifth of the range; spread over all of it, a sixth of the pixels are this dark and as many this bright.
  await eventually(async () => {
    const { dark, bright } = extremes(await editor.picture());
    expect(dark).toBeGreaterThan(0.1);
    expect(bright).toBeGreaterThan(0.1);
  });
  expect(errors).toEqual([]);
  await opened.close();
});
