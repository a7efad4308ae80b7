import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { BrowserContextOptions, Page } from 'playwright-core';
import type { Program } from '../../export/program/program.ts';
import { axeFindings } from '../support/axe.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { LAMP } from './controls-program.ts';
import { type ServedPage, servePage } from './page-kit.ts';

const chromium = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);

const CREDITS: Program['credits'] = [
  { title: 'Waves', kind: 'effect', credit: 'Ada, https://www.shadertoy.com/view/abc', licence: 'CC BY-NC-SA 3.0', nodes: ['waves-a'] },
  { title: 'assets/robot.glb', kind: 'asset', credit: '© Cy.', licence: '', nodes: ['robot-a'] },
];

let served: ServedPage;
beforeAll(async () => {
  served = await servePage({ ...LAMP, title: 'Warm light', credits: CREDITS });
});
afterAll(() => served.close());

const opened: Page[] = [];
afterEach(async () => {
  for (const page of opened.splice(0)) await page.context().close();
});

async function open(options: BrowserContextOptions = {}) {
  const context = await chromium.browser.newContext({ viewport: { width: 1280, height: 720 }, ...options });
  const page = await context.newPage();
  opened.push(page);
  const errors = collectErrors(page);
  await page.goto(served.url);
  // On phones it is behind the button “About this page”.
  await page.locator('.hint:not([hidden])').waitFor({ state: 'attached' });
  return { page, errors };
}

const SIZES = [
  ['a phone', 390, 844],
  ['a laptop', 1280, 720],
] as const;

describe('what every exported page has', () => {
  test('tells search engines and link previews what it is', async () => {
    const { page, errors } = await open();
    const content = (selector: string) => page.locator(selector).getAttribute('content');
    expect(await page.title()).toBe('Warm light');
    expect(await page.locator('html').getAttribute('lang')).toBe('en');
    expect(await content('meta[name="description"]')).toBe('A warm light for the room, drawn by a shader.');
    expect(await content('meta[name="theme-color"]')).toMatch(/^#[0-9a-f]{6}$/);
    expect(await content('meta[name="viewport"]')).toContain('width=device-width, initial-scale=1');
    expect(await content('meta[name="viewport"]')).not.toMatch(/user-scalable|maximum-scale/);
    const image = await content('meta[property="og:image"]');
    expect((await page.request.get(new URL(image ?? '', served.url).href)).headers()['content-type']).toBe('image/png');
    expect(await page.locator('img:not([alt])').count()).toBe(0);
    expect(await page.locator('h1').count()).toBe(1);
    expect(errors).toEqual([]);
  });

  test('says what it is before its script has come', async () => {
    const context = await chromium.browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    opened.push(page);
    await page.goto(served.url);
    expect(await page.getByRole('heading', { name: 'Warm light' }).isVisible()).toBe(true);
    expect(await page.getByText('A warm light for the room').isVisible()).toBe(true);
    expect(await page.locator('noscript').textContent()).toContain('This page needs JavaScript');
  });

  test('names whose works it shows, to those who ask', async () => {
    const { page, errors } = await open({ viewport: { width: 390, height: 844 } });
    const list = page.getByRole('listitem').filter({ hasText: 'Waves' });
    expect(await page.getByText('Credits', { exact: true }).isVisible()).toBe(false);
    await page.getByRole('button', { name: 'About this page' }).click();
    expect(await list.isVisible()).toBe(false);
    await page.getByText('Credits', { exact: true }).click();
    expect(await list.textContent()).toBe('Waves Ada, https://www.shadertoy.com/view/abc. CC BY-NC-SA 3.0.');
    expect(await page.getByRole('listitem').filter({ hasText: 'robot' }).textContent()).toBe('robot.glb © Cy.');
    expect(await page.getByRole('link').getAttribute('href')).toBe('https://www.shadertoy.com/view/abc');
    expect(await axeFindings(page)).toEqual([]);
    expect(errors).toEqual([]);
  });

  test.each(SIZES)('scrolls sideways nowhere, and axe finds nothing: %s', async (_name, width, height) => {
    const { page, errors } = await open({ viewport: { width, height } });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
    expect(await axeFindings(page)).toEqual([]);
    if (width < 480) await page.getByRole('button', { name: 'About this page' }).click();
    await page.getByText('Missing compared with AR').first().click();
    await page.getByRole('button', { name: 'Use the camera' }).click();
    await page.getByRole('button', { name: 'Stop the camera' }).waitFor();
    expect(await axeFindings(page)).toEqual([]);
    expect(errors).toEqual([]);
  });

  test('is walked through by keys in the order in which it is read', async () => {
    const { page, errors } = await open();
    const order: string[] = [];
    for (let i = 0; i < 10; i++) {
      await page.keyboard.press('Tab');
      const name = await page.evaluate(() => {
        const at = document.activeElement;
        const labels = at instanceof HTMLInputElement ? [...(at.labels ?? [])].map((label) => label.textContent ?? '') : [];
        return at?.getAttribute('aria-label') ?? (labels.join(' ') || (at?.textContent ?? ''));
      });
      order.push(name);
    }
    expect(order).toEqual([
      'Warm light: drag or use the arrow keys to look around',
      'About this page',
      'Use the camera',
      'Missing compared with AR',
      'Credits',
      'Controls',
      'Size',
      'Light',
      'Warm',
      'Greener',
    ]);
    expect(errors).toEqual([]);
  });

  test('shows its image without the script of its sessions, and says so where that cannot be loaded', async () => {
    const context = await chromium.browser.newContext({ viewport: { width: 640, height: 480 } });
    const page = await context.newPage();
    opened.push(page);
    await context.route('**/sessions-*.js', (route) => route.abort());
    await page.goto(served.url);
    await page.getByText('The page did not load completely, so AR and the camera are missing.').waitFor();
    expect(await page.getByRole('button', { name: 'Use the camera' }).isVisible()).toBe(false);
    expect(await page.locator('.poster.gone, canvas').count()).toBeGreaterThan(0);
    expect(await page.getByText('look around').isVisible()).toBe(true);
  });

  test('loads no sessions where there is none to enter, and else after its image', async () => {
    const requested = async (script: string) => {
      const context = await chromium.browser.newContext({ viewport: { width: 640, height: 480 } });
      const page = await context.newPage();
      opened.push(page);
      await page.addInitScript(script);
      const urls: string[] = [];
      page.on('request', (request) => urls.push(new URL(request.url()).pathname.split('/').pop() ?? ''));
      await page.goto(served.url);
      await page.getByText('look around').waitFor();
      return urls;
    };
    const without = await requested("Object.defineProperty(navigator, 'mediaDevices', { value: undefined })");
    expect(without.filter((name) => name.startsWith('sessions-'))).toEqual([]);
    const names = await requested('');
    const at = (start: string) => names.findIndex((name) => name.startsWith(start));
    expect(at('sessions-')).toBeGreaterThan(at('program-'));
    expect(at('program-')).toBeGreaterThan(-1);
  });

  test('moves nothing for those who ask for less motion', async () => {
    const { page } = await open({ reducedMotion: 'reduce' });
    const moving = await page.evaluate(() =>
      [...document.querySelectorAll('*')]
        .filter((element) => {
          const style = getComputedStyle(element);
          return style.animationName !== 'none' || style.transitionDuration !== '0s';
        })
        .map((element) => element.className),
    );
    expect(moving).toEqual([]);
  });

  test('draws nothing while its image stays the same', async () => {
    const context = await chromium.browser.newContext({ viewport: { width: 640, height: 480 } });
    const page = await context.newPage();
    opened.push(page);
    await page.addInitScript(() => {
      const { prototype } = WebGL2RenderingContext;
      const { drawArrays } = prototype;
      Object.assign(globalThis, { drawCalls: 0 });
      prototype.drawArrays = function (...call) {
        (globalThis as unknown as { drawCalls: number }).drawCalls++;
        drawArrays.apply(this, call);
      };
    });
    await page.goto(served.url);
    await page.getByText('look around').waitFor();
    /** Number of draws since the page began, after some more frames. */
    const drawnAfter = (frames: number) =>
      page.evaluate(async (count) => {
        for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
        return (globalThis as unknown as { drawCalls: number }).drawCalls;
      }, frames);
    const before = await drawnAfter(5);
    const shown = await page.locator('canvas').first().screenshot();
    expect(await drawnAfter(10)).toBe(before);
    expect((await page.locator('canvas').first().screenshot()).equals(shown)).toBe(true);
    await page.setViewportSize({ width: 480, height: 640 });
    const resized = await drawnAfter(10);
    expect(resized).toBeGreaterThan(before);
    expect(await drawnAfter(10)).toBe(resized);
  });
});
