import { expect } from '@jest/globals';
import type { Browser } from 'playwright-core';
import { collectErrors } from './browser.ts';
import { decodePicture } from './picture.ts';
import { serveStatic } from './serve.ts';

/** Opens an exported folder as a visitor does: it shows a picture, and nothing goes wrong. */
export async function visitExportedPage(browser: Browser, folder: string): Promise<void> {
  const host = await serveStatic({ '/': folder });
  const page = await browser.newPage({ viewport: { width: 640, height: 480 } });
  const errors = collectErrors(page);
  try {
    await page.goto(host.origin);
    await page.locator('canvas').first().waitFor();
    await page.waitForLoadState('networkidle');
    const { data } = decodePicture(await page.screenshot());
    const colours = new Set<number>();
    for (let i = 0; i < data.length; i += 4) colours.add(((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0));
    expect(colours.size).toBeGreaterThan(50);
    expect(errors).toEqual([]);
  } finally {
    await page.close();
    await host.close();
  }
}
