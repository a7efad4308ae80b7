import process from 'node:process';
import type { Browser } from 'playwright-core';

/** A slow phone network: 1.6 Mbit/s down, 0.75 up, 150 ms from request to answer. */
const NETWORK = { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: 0.75e6 / 8 };
const SIZE_PX = { width: 400, height: 300 };

/**
 * Visits a page over a slow network, without a cache.
 *
 * @param slowness Factor by which the processor is slowed down.
 * @param watch Page code that starts with the page, and sets `globalThis.seen` to a promise of the result.
 */
export async function visitSlowly<T>(browser: Browser, url: string, slowness: number, watch: () => void): Promise<T> {
  const context = await browser.newContext({ viewport: SIZE_PX, serviceWorkers: 'block' });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send('Network.enable');
  await client.send('Network.setCacheDisabled', { cacheDisabled: true });
  await client.send('Network.emulateNetworkConditions', NETWORK);
  await client.send('Emulation.setCPUThrottlingRate', { rate: slowness });
  await page.addInitScript(watch);
  await page.goto(url, { waitUntil: 'commit' });
  const seen = await page.evaluate(() => (globalThis as unknown as { readonly seen: Promise<T> }).seen);
  const picture = process.env.SCRIM_SLOW_VISIT;
  if (picture !== undefined) await page.screenshot({ path: picture });
  await context.close();
  return seen;
}
