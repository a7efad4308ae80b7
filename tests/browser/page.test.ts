import { readdir, readFile, rename } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { decode } from 'fast-png';
import type { BrowserContextOptions, Page } from 'playwright-core';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { serveProjectText } from '../support/project-page.ts';
import { DISC, type ServedPage, servePage } from './page-kit.ts';
import { MODEL, ROBOT } from './robot-project.ts';

const chromium = useBrowser();
let served: ServedPage;
beforeAll(async () => {
  served = await servePage(DISC);
});
afterAll(() => served.close());

const opened: Page[] = [];
afterEach(async () => {
  for (const page of opened.splice(0)) await page.close();
});

async function open(options: BrowserContextOptions = {}, url = served.url) {
  const page = await chromium.browser.newPage({ viewport: { width: 1280, height: 720 }, ...options });
  opened.push(page);
  const errors = collectErrors(page);
  await page.goto(url);
  return { page, errors };
}

/** `[r, g, b]` of the page as it is seen, at a fraction of its size. */
async function colorAt(page: Page, x: number, y: number): Promise<number[]> {
  const { width, data, channels, height } = decode(await page.screenshot());
  const at = (Math.floor(y * height) * width + Math.floor(x * width)) * channels;
  return [...data.slice(at, at + 3)];
}

describe('an exported page where there is no AR', () => {
  test('shows the picture over its own background, says why there is no AR, and logs nothing', async () => {
    const { page, errors } = await open();
    await page.getByText('This browser has no AR').or(page.getByText('This device offers no AR')).waitFor();
    expect(await page.getByRole('button', { name: 'Enter AR' }).isVisible()).toBe(false);
    expect(await page.getByRole('heading', { name: 'Warm light' }).isVisible()).toBe(true);
    const [red = 0, , blue = 0] = await colorAt(page, 0.5, 0.5);
    expect(red - blue).toBeGreaterThan(100);
    const corner = await colorAt(page, 0.98, 0.98);
    expect(Math.max(...corner)).toBeLessThan(80);
    expect(errors).toEqual([]);
  });

  test('requests only its own files, and only those that it needs', async () => {
    const page = await chromium.browser.newPage();
    opened.push(page);
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    await page.goto(served.url);
    await page.getByText('AR').first().waitFor();
    await page.getByText('look around').waitFor();
    const own = asked.map((url) => url.slice(served.url.length)).sort();
    expect(asked.every((url) => url.startsWith(served.url) || url.startsWith('data:'))).toBe(true);
    // The service worker keeps itself and loads nothing that the page does not; the neutral poster is for those who link to it.
    const others = /^(index\.html|report\.json|offline\.js|poster-.*)$/;
    const files = (await readdir(served.folder)).filter((name) => !others.test(name));
    expect(own.filter((path) => path !== '' && !path.startsWith('data:'))).toEqual(files.sort());
  });

  test('can be used with the keyboard alone', async () => {
    const { page } = await open();
    await page.getByText('look around').waitFor();
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement?.tagName)).toBe('CANVAS');
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement?.getAttribute('aria-label'))).toBe('About this page');
    await page.keyboard.press('Enter');
    expect(await page.getByText('look around').isVisible()).toBe(false);
    expect(await page.getByRole('button', { name: 'About this page' }).getAttribute('aria-expanded')).toBe('false');
  });

  test.each([
    ['a phone', 390, 844],
    ['a laptop', 1280, 720],
    ['a small phone held across', 640, 320],
  ])('fits %s, and every control can be hit', async (_name, width, height) => {
    const { page } = await open({ viewport: { width, height } });
    await page.locator('.hint:not([hidden])').waitFor({ state: 'attached' });
    expect(await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight])).toEqual([
      width,
      height,
    ]);
    for (const button of await page.getByRole('button').all()) {
      if (!(await button.isVisible())) continue;
      const box = await button.boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
      expect((await button.getAttribute('aria-label')) ?? (await button.textContent())).not.toBe('');
    }
  });
});

describe('an exported page while it loads', () => {
  test('shows how far it is, and the picture when all is there', async () => {
    const slow = await serveProjectText(ROBOT, { 'assets/robot.glb': MODEL });
    const page = await chromium.browser.newPage();
    opened.push(page);
    let letThrough = () => {};
    const held = new Promise<void>((resolve) => {
      letThrough = resolve;
    });
    await page.route('**/assets/*', async (route) => {
      await held;
      await route.continue();
    });
    await page.goto(slow.url);
    const bar = page.getByRole('progressbar', { name: 'Loading' });
    // The program has come, the model has not: a beginning, far from the end.
    await page.waitForFunction(() => (document.querySelector('progress')?.value ?? 0) > 0);
    expect(await bar.evaluate((progress) => (progress as HTMLProgressElement).value)).toBeLessThan(0.5);
    expect(await page.getByText('look around').isVisible()).toBe(false);
    letThrough();
    await page.getByText('look around').waitFor();
    expect(await bar.isVisible()).toBe(false);
    await slow.close();
  });
});

describe('an exported page in trouble', () => {
  test('says so when its program is missing', async () => {
    const broken = await servePage({ ...DISC, title: 'Broken' });
    const name = (await readdir(broken.folder)).find((file) => file.startsWith('program-')) as string;
    await rename(join(broken.folder, name), join(broken.folder, 'gone.json'));
    const { page } = await open({}, broken.url);
    await page.getByText('did not load completely').waitFor();
    await broken.close();
  });

  test('says so when a model is missing, and shows the rest', async () => {
    const broken = await serveProjectText(ROBOT, { 'assets/robot.glb': MODEL });
    const [name = ''] = await readdir(join(broken.folder, 'assets'));
    await rename(join(broken.folder, 'assets', name), join(broken.folder, 'assets', 'gone'));
    const { page } = await open({}, broken.url);
    await page.getByRole('alert').getByText('robot').waitFor();
    await page.getByText('look around').waitFor();
    const [red = 0, green = 255] = await colorAt(page, 0.5, 0.5);
    expect(red - green).toBeGreaterThan(60);
    await broken.close();
  });

  test('says so when the browser has no WebGL 2', async () => {
    const page = await chromium.browser.newPage();
    opened.push(page);
    const errors = collectErrors(page);
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto(served.url);
    await page.getByText('no WebGL 2').waitFor();
    expect(errors).toEqual([]);
  });

  test('says so when the graphics are lost, and takes it back when they return', async () => {
    const { page } = await open();
    await page.getByText('look around').waitFor();
    await page.evaluate(() => {
      const gl = document.querySelector('canvas')?.getContext('webgl2');
      Object.assign(window, { lose: gl?.getExtension('WEBGL_lose_context') });
      (window as unknown as { lose: WEBGL_lose_context }).lose.loseContext();
    });
    await page.getByRole('alert').getByText('Graphics were interrupted').waitFor();
    await page.evaluate(() => (window as unknown as { lose: WEBGL_lose_context }).lose.restoreContext());
    await page.getByText('Graphics were interrupted').waitFor({ state: 'detached' });
    const [red = 0, , blue = 0] = await colorAt(page, 0.5, 0.5);
    expect(red - blue).toBeGreaterThan(100);
  });

  test('runs no script that its host slips in', async () => {
    const html = await readFile(join(served.folder, 'index.html'), 'utf8');
    const page = await chromium.browser.newPage();
    opened.push(page);
    await page.route('**/', (route) =>
      route.fulfill({ body: html.replace('</body>', '<script>window.slipped = 1</script></body>'), contentType: 'text/html' }),
    );
    await page.goto(served.url);
    await page.getByText('look around').waitFor();
    expect(await page.evaluate(() => 'slipped' in window)).toBe(false);
  });
});
