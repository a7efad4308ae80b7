import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect } from '@jest/globals';
import type { Browser, Page } from 'playwright-core';
import { collectErrors, drawPageSeldom } from './browser.ts';
import { decodeImage } from './image.ts';
import { countColors } from './pixels.ts';
import { serveStatic } from './serve.ts';

/** Waits until an exported page has drawn its first image. Pages whose image depends on the view then say how to look around, others do not. */
export async function pageReady(page: Page): Promise<void> {
  await page.waitForFunction(() => document.querySelector<HTMLElement>('.panel .loading')?.hidden === true);
}

/** Opens an exported folder like a visitor, and checks that it draws and reports no errors. */
export async function visitExportedPage(browser: Browser, folder: string): Promise<void> {
  const host = await serveStatic({ '/': folder });
  const page = await browser.newPage({ viewport: { width: 640, height: 480 } });
  const errors = collectErrors(page);
  await drawPageSeldom(page);
  try {
    await page.goto(host.origin);
    await pageReady(page);
    expect(countColors(decodeImage(await page.screenshot()))).toBeGreaterThan(50);
    expect(errors).toEqual([]);
  } finally {
    await page.close();
    await host.close();
  }
}

/** Checks that the poster of an exported folder is not empty and is shown while the page loads. */
export async function expectPoster(browser: Browser, folder: string): Promise<void> {
  const name = (await readdir(folder)).find((file) => file.startsWith('poster-')) ?? '';
  expect(name).toMatch(/\.jpg$/);
  expect(await readFile(join(folder, 'index.html'), 'utf8')).toContain(`<img class="poster" src="${name}"`);
  const bytes = [...(await readFile(join(folder, name)))];
  const page = await browser.newPage();
  const found = await page.evaluate(async (jpeg) => {
    const { width, height, data } = await decode(new Uint8Array(jpeg));
    const colors = new Set<number>();
    for (let i = 0; i < data.length; i += 4) {
      colors.add((((data[i] ?? 0) >> 3) << 10) | (((data[i + 1] ?? 0) >> 3) << 5) | ((data[i + 2] ?? 0) >> 3));
    }
    return { width, height, colors: colors.size };

    async function decode(file: Uint8Array<ArrayBuffer>): Promise<{ data: Uint8ClampedArray; width: number; height: number }> {
      const picture = await createImageBitmap(new Blob([file]));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      context?.drawImage(picture, 0, 0);
      const data = context?.getImageData(0, 0, picture.width, picture.height).data ?? new Uint8ClampedArray();
      return { data, width: picture.width, height: picture.height };
    }
  }, bytes);
  expect(found).toMatchObject({ width: 1200, height: 630 });
  expect(found.colors).toBeGreaterThan(200);
  await page.close();
}
