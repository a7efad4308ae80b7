import { mkdir, writeFile } from 'node:fs/promises';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, encodeImage, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { openXrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
let served: ServedExport;

beforeAll(async () => {
  served = await serveProject('examples/boards/gallery');
});
afterAll(() => served.close());

/** The dark gray of the board behind all cells, wherever nothing of the page lies over it. */
function isBoard(data: Uint8Array, i: number): boolean {
  const [r = 0, g = 0, b = 0] = data.subarray(i, i + 3);
  return r > 30 && b < 75 && Math.abs(r - g) <= 4 && b - r >= 2 && b - r <= 12;
}

/** The part of an image, or of its part, that is board, and whether some of it lies at an edge: but below, in headsets, hangs the panel. */
function boardIn(
  { width, height, data }: RgbaImage,
  fromX = 0,
  toX = width,
  hasPanel = false,
): { readonly share: number; readonly cut: boolean } {
  let [count, cut] = [0, 0];
  for (let y = 0; y < height; y++) {
    for (let x = fromX; x < toX; x++) {
      if (!isBoard(data, (y * width + x) * 4)) continue;
      count++;
      if (x === fromX || x === toX - 1 || y === 0 || (y === height - 1 && !hasPanel)) cut++;
    }
  }
  // A few pixels of a room have its color, too.
  return { share: count / (height * (toX - fromX)), cut: cut > 4 };
}

/** Bounds of what is neither gray nor dark, pixels. */
function colorful({ width, height, data }: RgbaImage) {
  let [left, right, top, bottom] = [width, 0, height, 0];
  for (let i = 0; i < width * height; i++) {
    const rgb = data.subarray(4 * i, 4 * i + 3);
    if (Math.max(...rgb) - Math.min(...rgb) < 60) continue;
    const [x, y] = [i % width, Math.floor(i / width)];
    [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
  }
  return { left, right, top, bottom };
}

/** In the page: two frames later, what lies over the image is gone. */
async function showCanvasAlone(): Promise<void> {
  const canvas = document.querySelector('canvas');
  for (const element of document.querySelectorAll<HTMLElement>('body *')) {
    if (!element.contains(canvas)) element.style.visibility = 'hidden';
  }
  await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
}

async function keep(name: string, picture: RgbaImage): Promise<void> {
  await mkdir('tests/output/gallery', { recursive: true });
  await writeFile(`tests/output/gallery/${name}.png`, encodeImage(picture));
}

describe('the whole wall is in view, and large', () => {
  test.each([
    [390, 844],
    [1280, 720],
  ])('on a page of %d×%d pixels without AR', async (width, height) => {
    const page = await chromium.browser.newPage({ viewport: { width, height } });
    const errors = collectErrors(page);
    await page.goto(served.url);
    await page.locator('.hint:not([hidden])').waitFor({ state: 'attached' });
    await page.evaluate(showCanvasAlone);
    const picture = decodeImage(await page.screenshot());
    await keep(`page-${width}`, picture);
    // Of the colors of the cells, from the first row's balls to the blended bars.
    const { left, right, top, bottom } = colorful(picture);
    expect(Math.min(left, top, width - right, height - bottom)).toBeGreaterThan(4);
    expect(Math.max((right - left) / width, (bottom - top) / height)).toBeGreaterThan(0.4);
    expect(errors).toEqual([]);
    await page.close();
  });

  test.each([
    ['phone held upright', { device: 'phone', views: 1, sizePx: [240, 520] }, 1],
    ['phone held across', { device: 'phone', views: 1, sizePx: [520, 240] }, 1],
    ['headset', { device: 'headset', views: 2, sizePx: [640, 320] }, 2],
  ] as const)('in AR, on a %s at its start', async (name, options, views) => {
    const [width, height] = options.sizePx;
    const xr = await openXrPage(chromium.browser, served.url, { room: 'studio', ...options } as EmulatorOptions, { width, height });
    await xr.enter();
    await xr.step(2);
    const picture = await xr.readLayer();
    await keep(name, await xr.readComposite());
    for (let view = 0; view < views; view++) {
      const { share, cut } = boardIn(picture, (picture.width / views) * view, (picture.width / views) * (view + 1), views === 2);
      expect([view, cut]).toEqual([view, false]);
      expect(share).toBeGreaterThan(0.08);
    }
    expect(xr.errors).toEqual([]);
    await xr.close();
  });
});
