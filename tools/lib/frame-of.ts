import type { Frame, Page } from 'playwright-core';

/**
 * The frame of an iframe, once it shows a page. The element is asked, because a page still lists the frame of a removed iframe until the process
 * of that frame ends.
 *
 * @param iframe Selector of the iframe.
 */
export async function frameOf(page: Page, iframe = 'iframe[title="Preview"]'): Promise<Frame> {
  const element = await page.waitForSelector(iframe, { state: 'attached' });
  const frame = await element.contentFrame();
  if (frame === null) throw new Error(`${iframe} was removed.`);
  await frame.waitForURL(({ href }) => href !== 'about:blank', { waitUntil: 'commit' });
  return frame;
}
