import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { LAMP } from './controls-program.ts';
import { DISC, type ServedPage, servePage } from './page-kit.ts';

const chromium = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);
let served: ServedPage;
beforeAll(async () => {
  served = await servePage(LAMP);
});
afterAll(() => served.close());

const opened: Page[] = [];
afterEach(async () => {
  for (const page of opened.splice(0)) await page.close();
});

async function open(width = 1280, height = 720) {
  const page = await chromium.browser.newPage({ viewport: { width, height } });
  opened.push(page);
  const errors = collectErrors(page);
  await page.goto(served.url);
  // On phones it is behind the button “About this page”.
  await page.locator('.hint:not([hidden])').waitFor({ state: 'attached' });
  return { page, errors };
}

type Color = readonly [red: number, green: number, blue: number];

async function colorAt(page: Page, x: number, y: number): Promise<Color> {
  const [r, g, b] = pixelAt(decodeImage(await page.screenshot({ clip: { x, y, width: 1, height: 1 } })), 0, 0);
  return [r, g, b];
}

/** A set value is drawn with the next frame, whenever that comes. */
async function untilColor(page: Page, x: number, y: number, is: (color: Color) => boolean): Promise<void> {
  while (!is(await colorAt(page, x, y)));
}

const red = ([r, g, b]: Color) => r > 200 && g < 60 && b < 60;
const blue = ([r, g, b]: Color) => b > 200 && r < 60 && g < 60;
const empty = ([r, g, b]: Color) => Math.max(r, g, b) < 110;

describe('controls of an exported page', () => {
  test('change the picture, by pointer, and say what they are set to', async () => {
    const { page, errors } = await open();
    // The middle is within the disc; a quarter of the page's height above it, only within a larger one.
    await untilColor(page, 640, 360, red);
    expect(empty(await colorAt(page, 640, 60))).toBe(true);
    const slider = page.getByRole('slider', { name: 'Size' });
    expect(await page.locator('output').textContent()).toBe('0.3');
    await slider.fill('0.5');
    await untilColor(page, 640, 60, red);
    expect(await page.locator('output').textContent()).toBe('0.5');

    await page.getByRole('radio', { name: 'Cold' }).click();
    await untilColor(page, 640, 360, blue);
    expect(await page.getByRole('radio', { name: 'Cold' }).isChecked()).toBe(true);
    await page.getByRole('button', { name: 'Greener' }).click({ clickCount: 4 });
    await untilColor(page, 640, 360, ([, g]) => g > 200);
    await page.getByRole('switch', { name: 'Light' }).click();
    await untilColor(page, 640, 360, empty);
    expect(errors).toEqual([]);
  });

  test('can be used by keyboard alone', async () => {
    const { page } = await open();
    await page.getByRole('button', { name: 'Controls' }).focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('ArrowRight');
    expect(await page.locator('output').textContent()).toBe('0.4');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Space');
    await untilColor(page, 640, 360, empty);
    await page.keyboard.press('Space');
    await page.keyboard.press('Tab');
    await page.keyboard.press('ArrowDown');
    await untilColor(page, 640, 360, blue);
    await page.keyboard.press('Tab');
    for (let i = 0; i < 4; i++) await page.keyboard.press('Enter');
    await untilColor(page, 640, 360, ([, g]) => g > 200);
  });

  test('keep what they are set to with the camera, and when the graphics were lost', async () => {
    const { page, errors } = await open();
    await page.getByRole('radio', { name: 'Cold' }).click();
    await page.getByRole('button', { name: 'Use the camera' }).click();
    await page.getByRole('button', { name: 'Stop the camera' }).waitFor();
    await untilColor(page, 640, 360, blue);
    await page.getByRole('radio', { name: 'Warm' }).click();
    await untilColor(page, 640, 360, red);
    await page.getByRole('radio', { name: 'Cold' }).click();
    await page.evaluate(() => {
      const lose = document.querySelector('canvas')?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
      Object.assign(window, { lose });
      lose?.loseContext();
    });
    await page.getByRole('alert').getByText('Graphics were interrupted').waitFor();
    await page.evaluate(() => (window as unknown as { lose: WEBGL_lose_context }).lose.restoreContext());
    await page.getByText('Graphics were interrupted').waitFor({ state: 'detached' });
    await untilColor(page, 640, 360, blue);
    expect(errors).toEqual([]);
  });

  test('are folded on a phone, and fit it when they are opened', async () => {
    const { page } = await open(390, 844);
    const fold = page.getByRole('button', { name: 'Controls' });
    const slider = page.getByRole('slider', { name: 'Size' });
    expect([await fold.getAttribute('aria-expanded'), await slider.isVisible()]).toEqual(['false', false]);
    await fold.click();
    expect([await fold.getAttribute('aria-expanded'), await slider.isVisible()]).toEqual(['true', true]);
    const panel = await page.getByRole('region', { name: 'Controls' }).boundingBox();
    const card = await page.getByRole('region', { name: 'Lamp' }).boundingBox();
    expect(panel?.x).toBeGreaterThanOrEqual(0);
    expect((panel?.y ?? 0) + (panel?.height ?? 0)).toBeLessThanOrEqual(card?.y ?? 0);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    for (const control of await page.locator('.controls button, .controls label:has(input), .controls [type=range]').all()) {
      expect((await control.boundingBox())?.height).toBeGreaterThanOrEqual(44);
    }
  });

  test('are folded on a phone even if they are few, until a session is entered', async () => {
    const few = await servePage({ ...LAMP, controls: LAMP.controls?.slice(1, 3) ?? [] });
    const page = await chromium.browser.newPage({ viewport: { width: 390, height: 844 } });
    opened.push(page);
    await page.goto(few.url);
    const fold = page.getByRole('button', { name: 'Controls' });
    await fold.waitFor();
    expect(await fold.getAttribute('aria-expanded')).toBe('false');
    await page.getByRole('button', { name: 'Use the camera' }).click();
    await page.getByRole('switch', { name: 'Light' }).waitFor();
    await page.getByRole('button', { name: 'Stop the camera' }).click();
    await page.getByRole('switch', { name: 'Light' }).waitFor({ state: 'hidden' });
    await few.close();
  });

  test('are not there where there is nothing to set', async () => {
    const without = await servePage(DISC);
    const page = await chromium.browser.newPage();
    opened.push(page);
    await page.goto(without.url);
    await page.getByText('look around').waitFor();
    expect(await page.getByText('Controls').count()).toBe(0);
    await without.close();
  });
});
