import { cp, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { BrowserContext, Page } from 'playwright-core';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { serveStatic } from '../support/serve.ts';
import { DISC, servePage } from './page-kit.ts';
import { MODEL, ROBOT } from './robot-project.ts';

const chromium = useBrowser();
let served: ServedExport;
let single: ServedExport;
beforeAll(async () => {
  served = await serveProjectText(ROBOT, { 'assets/robot.glb': MODEL });
  single = await serveProjectText(ROBOT, { 'assets/robot.glb': MODEL }, { singleFile: true });
});
afterAll(async () => {
  await served.close();
  await single.close();
});

const opened: BrowserContext[] = [];
afterEach(async () => {
  for (const context of opened.splice(0)) await context.close();
});

async function visit(url: string): Promise<{ context: BrowserContext; page: Page; errors: string[] }> {
  const context = await chromium.browser.newContext({ viewport: { width: 1280, height: 720 } });
  opened.push(context);
  const page = await context.newPage();
  const errors = collectErrors(page);
  await page.goto(url);
  await page.getByText('look around').waitFor();
  return { context, page, errors };
}

/** The red box of the project, in the middle of the view. */
async function expectBox(page: Page): Promise<void> {
  const picture = decodeImage(await page.screenshot());
  const [red, green] = pixelAt(picture, 640, 360);
  expect(red - green).toBeGreaterThan(60);
}

/** When the browser has kept all that the page needs. */
async function untilKept(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
}

const cacheNames = (page: Page): Promise<string[]> => page.evaluate(() => caches.keys());

describe('a page that was visited once', () => {
  test('opens without a connection, model and all, with index.html in its address too', async () => {
    const host = await serveStatic({ '/somewhere/deep below/': `${served.folder}/` });
    const url = `${host.origin}/somewhere/deep%20below/`;
    const { context, page, errors } = await visit(url);
    await untilKept(page);
    await context.setOffline(true);
    // Emulated offline does not apply to workers, so the server stops answering.
    await host.close();
    await page.reload();
    await page.getByText('look around').waitFor();
    await expectBox(page);
    await page.goto(`${url}index.html?from=mail`);
    await page.getByText('look around').waitFor();
    await expectBox(page);
    expect(errors).toEqual([]);
  });

  test('is seen in its new version at once; the old one’s files go, those of its neighbors stay', async () => {
    const folder = `${served.folder}-host`;
    const first = await servePage(DISC);
    const second = await servePage({ ...DISC, title: 'Warmer light' });
    await mkdir(folder);
    await cp(first.folder, join(folder, 'light'), { recursive: true });
    const host = await serveStatic({ '/pages/': `${folder}/` });
    try {
      const { context, page, errors } = await visit(`${host.origin}/pages/light/`);
      await untilKept(page);
      const before = await cacheNames(page);
      await page.evaluate(() => caches.open('a neighbor’s'));
      await rm(join(folder, 'light'), { recursive: true });
      await cp(second.folder, join(folder, 'light'), { recursive: true });
      await page.reload();
      await page.getByRole('heading', { name: 'Warmer light' }).waitFor();
      await page.evaluate(async () => {
        const registration = await navigator.serviceWorker.ready;
        await registration.update();
        while (registration.installing) await new Promise((resolve) => setTimeout(resolve, 50));
      });
      await page.close();
      // The new worker waits until the old page is closed everywhere, which the browser notices after a while.
      let again = await context.newPage();
      for (;;) {
        await again.goto(`${host.origin}/pages/light/`);
        await again.getByText('look around').waitFor();
        if (!(await cacheNames(again)).includes(before[0] ?? '')) break;
        await again.close();
        again = await context.newPage();
      }
      const after = await cacheNames(again);
      expect(before).toHaveLength(1);
      expect(after).toHaveLength(2);
      expect(after).toContain('a neighbor’s');
      await context.setOffline(true);
      await again.reload();
      await again.getByRole('heading', { name: 'Warmer light' }).waitFor();
      expect(errors).toEqual([]);
    } finally {
      await host.close();
      await first.close();
      await second.close();
      await rm(folder, { recursive: true });
    }
  });

  test('works as well where nothing may be kept', async () => {
    const context = await chromium.browser.newContext({ serviceWorkers: 'block' });
    opened.push(context);
    const page = await context.newPage();
    const errors = collectErrors(page);
    await page.addInitScript(() => {
      Object.defineProperty(navigator, 'serviceWorker', {
        get: () => {
          throw new DOMException('', 'SecurityError');
        },
      });
    });
    await page.goto(served.url);
    await page.getByText('look around').waitFor();
    expect(errors).toEqual([]);
  });
});

describe('a page in one file', () => {
  test('is one file that requests nothing', async () => {
    expect((await readdir(single.folder)).sort()).toEqual(['index.html', 'report.json']);
    const html = await readFile(join(single.folder, 'index.html'), 'utf8');
    const policy = /http-equiv="content-security-policy" content="([^"]+)"/.exec(html)?.[1];
    expect(policy).toMatch(
      /^default-src 'none'; script-src 'sha256-[^']+'( 'wasm-unsafe-eval')?; style-src 'sha256-[^']+'; img-src data:;/,
    );
    expect(policy).not.toMatch(/unsafe-inline|'self'|https?:|connect-src/);
  });

  test('opens by a double click, from a folder with spaces and letters of all kinds', async () => {
    const folder = join(`${single.folder}-file`, 'Röböt & Söhne #1');
    await mkdir(folder, { recursive: true });
    await cp(join(single.folder, 'index.html'), join(folder, 'My robot.html'));
    const { page, errors } = await visit(pathToFileURL(join(folder, 'My robot.html')).href);
    await expectBox(page);
    expect(errors).toEqual([]);
    await rm(`${single.folder}-file`, { recursive: true });
  });

  test('runs no script that is slipped into it', async () => {
    const folder = `${single.folder}-slipped`;
    await mkdir(folder);
    const html = await readFile(join(single.folder, 'index.html'), 'utf8');
    await writeFile(join(folder, 'page.html'), html.replace('</body>', '<script>window.slipped = 1</script></body>'));
    const { page } = await visit(pathToFileURL(join(folder, 'page.html')).href);
    expect(await page.evaluate(() => 'slipped' in window)).toBe(false);
    await rm(folder, { recursive: true });
  });

  test('works on a host as well', async () => {
    const { page, errors } = await visit(single.url);
    await expectBox(page);
    expect(errors).toEqual([]);
  });
});
