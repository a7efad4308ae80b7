import { decode } from 'fast-png';
import type { Page } from 'playwright-core';

const PREVIEW = 'iframe[title="Preview"]';
/**
 * Part of the preview that is read to detect a new image, in pixels: below the strip that messages may cover, and small, so that reading is
 * fast.
 */
const LOOK = { x: 40, y: 60, width: 24, height: 24 };

/** Waits until the preview shows its first image, which is not of one color as the empty panel is. */
export async function drawn(page: Page): Promise<void> {
  await page.locator(PREVIEW).waitFor();
  while (isPlain(await look(page))) failIfClosed(page);
}

function isPlain(png: Buffer): boolean {
  const { data, channels } = decode(png);
  return data.every((value, i) => value === data[i % channels]);
}

/** Waits until the preview looks other than `before`. */
export async function changed(page: Page, before: Buffer): Promise<void> {
  while ((await look(page)).equals(before)) failIfClosed(page);
}

function failIfClosed(page: Page): void {
  if (page.isClosed()) throw new Error('The editor is gone.');
}

export async function look(page: Page): Promise<Buffer> {
  const box = await page.locator(PREVIEW).boundingBox();
  if (!box) throw new Error('There is no preview.');
  return page.screenshot({ clip: { ...LOOK, x: box.x + LOOK.x, y: box.y + LOOK.y } });
}
