import { bundleScript } from '../../app/services/bundle-script.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';

/** WebCodecs requires a secure origin. No request reaches this address. */
const ADDRESS = 'https://film.invalid/';

/** Encodes an example video in the pinned browser, which always produces the same bytes. */
export async function makeFilm(root: string, film: 'makeBall' | 'makeStripes'): Promise<Uint8Array> {
  const found = await findChromium({ pinnedOnly: true });
  if (!found) throw new Error('The pinned Chromium is missing: run `npm ci` on Linux x64.');
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage();
    await page.route(ADDRESS, (route) => route.fulfill({ contentType: 'text/html', body: '<!doctype html><title>film</title>' }));
    await page.goto(ADDRESS);
    await page.addScriptTag({ content: await bundleScript(root, 'tools/examples/film.page.ts', 'film') });
    const bytes = await page.evaluate(`film.${film}()`);
    return Uint8Array.from(bytes as number[]);
  } finally {
    await browser.close();
  }
}
