import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import { DISC, type ServedPage, servePage } from '../browser/page-kit.ts';
import { collectErrors, drawPageSeldom, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { eventually } from '../support/patience.ts';

// Chromium's own fake camera, green with a pie that fills; and its visitor, who says yes to everything, or no.
const chromium = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);
const refusing = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream=deny']);

let served: ServedPage;
beforeAll(async () => {
  served = await servePage(DISC);
});
afterAll(() => served.close());

const opened: Page[] = [];
afterEach(async () => {
  for (const page of opened.splice(0)) await page.context().close();
});

async function open(
  options: BrowserContextOptions = {},
  prepare: (page: Page) => Promise<unknown> = async () => {},
  browser: Browser = chromium.browser,
  url = served.url,
) {
  const context = await browser.newContext({ viewport: { width: 640, height: 480 }, ...options });
  const page = await context.newPage();
  opened.push(page);
  const errors = collectErrors(page);
  await drawPageSeldom(page);
  await prepare(page);
  await page.goto(url);
  const use = page.getByRole('button', { name: 'Use the camera' });
  await use.waitFor();
  return { page, errors, use };
}

async function shot(page: Page): Promise<RgbaImage> {
  return decodeImage(await page.screenshot());
}

/** Corners are where the fake camera is green and the disc is not. */
const isGreen = (picture: RgbaImage, x: number, y: number): boolean => {
  const [red = 255, green = 0, blue = 255] = pixelAt(picture, x, y);
  return green > 100 && red < green - 60 && blue < green - 60;
};

/** Frames are there when the page's image says so, not when a time has passed. */
async function untilGreen(page: Page): Promise<RgbaImage> {
  const y = (page.viewportSize()?.height ?? 0) - 8;
  while (!isGreen(decodeImage(await page.screenshot({ clip: { x: 8, y, width: 1, height: 1 } })), 0, 0));
  return shot(page);
}

async function liveTracks(page: Page): Promise<number> {
  return page.evaluate(() => (window as unknown as { tracks: MediaStreamTrack[] }).tracks.filter((t) => t.readyState === 'live').length);
}

/** Remembers what the page was given, to see that it gives it back. */
async function watchTracks(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const tracks: MediaStreamTrack[] = [];
    Object.assign(window, { tracks });
    const ask = navigator.mediaDevices.getUserMedia.bind(navigator.mediaDevices);
    navigator.mediaDevices.getUserMedia = async (wishes) => {
      const stream = await ask(wishes);
      tracks.push(...stream.getTracks());
      return stream;
    };
  });
}

describe('an exported page with a camera and no AR', () => {
  test('says what will be asked and what is missing; shows the camera behind the picture; gives it back', async () => {
    const { page, errors, use } = await open({}, watchTracks);
    const about = await page.locator(`#${await use.getAttribute('aria-describedby')}`).textContent();
    expect(about).toContain('Your browser will ask for the camera');
    expect(about).toContain('do not stay in place as you walk');
    expect(about).toContain('It shines through everything.');
    expect(await page.evaluate(() => (window as unknown as { tracks: unknown[] }).tracks.length)).toBe(0);

    await use.click();
    const stop = page.getByRole('button', { name: 'Stop the camera' });
    await stop.waitFor();
    const picture = await untilGreen(page);
    const [red, , blue] = pixelAt(picture, 320, 240);
    expect(red - blue).toBeGreaterThan(100);
    expect(await page.getByRole('heading', { name: 'Warm light' }).isVisible()).toBe(false);
    expect(await liveTracks(page)).toBe(1);

    await stop.click();
    await use.waitFor();
    expect(await liveTracks(page)).toBe(0);
    expect(isGreen(await shot(page), 8, 472)).toBe(false);
    expect(await page.evaluate(() => document.activeElement?.textContent)).toBe('Use the camera');
    expect(errors).toEqual([]);
  });

  test('can be entered and left repeatedly', async () => {
    const { page, errors, use } = await open({}, watchTracks);
    for (let i = 0; i < 3; i++) {
      await use.click();
      await page.getByRole('button', { name: 'Stop the camera' }).waitFor();
      await page.keyboard.press('Escape');
      await use.waitFor();
    }
    expect(await liveTracks(page)).toBe(0);
    await use.click();
    await untilGreen(page);
    expect(errors).toEqual([]);
  });

  test('turns the camera off while it is hidden, and on again', async () => {
    const { page, errors, use } = await open({}, watchTracks);
    await use.click();
    await untilGreen(page);
    const setHidden = (hidden: boolean) =>
      page.evaluate(
        (state) => {
          Object.defineProperty(document, 'visibilityState', { value: state, configurable: true });
          document.dispatchEvent(new Event('visibilitychange'));
        },
        hidden ? 'hidden' : 'visible',
      );
    await setHidden(true);
    expect(await liveTracks(page)).toBe(0);
    await setHidden(false);
    await page.waitForFunction(() => (window as unknown as { tracks: MediaStreamTrack[] }).tracks.some((t) => t.readyState === 'live'));
    await untilGreen(page);
    expect(errors).toEqual([]);
  });

  test('goes back to looking around when the camera is taken away, and says so', async () => {
    const { page, errors, use } = await open({}, watchTracks);
    await use.click();
    await untilGreen(page);
    await page.evaluate(() => {
      for (const track of (window as unknown as { tracks: MediaStreamTrack[] }).tracks) track.dispatchEvent(new Event('ended'));
    });
    await page.getByText('The camera stopped').waitFor();
    expect(await use.isEnabled()).toBe(true);
    expect(await liveTracks(page)).toBe(0);
    expect(errors).toEqual([]);
  });

  test('says that it cannot follow turns where nothing tells of them, and takes it back when something does', async () => {
    const { page, use } = await open();
    await use.click();
    await page.getByText('This device has no motion sensor').waitFor();
    await page.evaluate(() => window.dispatchEvent(new DeviceOrientationEvent('deviceorientation', { alpha: 10, beta: 80, gamma: 0 })));
    await page.getByText('This device has no motion sensor').waitFor({ state: 'detached' });
  });

  test('covers the page whatever its shape, as the page is turned', async () => {
    const { page, errors, use } = await open({ viewport: { width: 390, height: 844 } });
    await use.click();
    await untilGreen(page);
    await page.setViewportSize({ width: 844, height: 390 });
    for (;;) {
      const picture = await shot(page);
      const corners = [8, 836].map((x) => isGreen(picture, x, 195));
      if (picture.width === 844 && corners.every(Boolean)) break;
    }
    expect(errors).toEqual([]);
  });
});

describe('an exported page whose image does not depend on the view', () => {
  let filter: ServedPage;
  beforeAll(async () => {
    filter = await servePage({ ...DISC, needs: DISC.needs.filter(({ capability }) => capability === 'camera-image') });
  });
  afterAll(() => filter.close());

  test('does not ask for the motion sensor, and says nothing about looking around', async () => {
    const { page, errors, use } = await open(
      {},
      (opening) =>
        opening.addInitScript(() => {
          const asked: string[] = [];
          Object.assign(window, { asked });
          Object.defineProperty(DeviceOrientationEvent, 'requestPermission', {
            value: async () => {
              asked.push('motion');
              return 'granted';
            },
          });
        }),
      chromium.browser,
      filter.url,
    );
    expect(await page.getByText('look around').isVisible()).toBe(false);
    await use.click();
    await page.getByRole('button', { name: 'Stop the camera' }).waitFor();
    const picture = await untilGreen(page);
    const [red, , blue] = pixelAt(picture, 320, 240);
    expect(red - blue).toBeGreaterThan(100);
    expect(await page.getByText('Turn the device').count()).toBe(0);
    expect(await page.evaluate(() => (window as unknown as { asked: string[] }).asked)).toEqual([]);
    expect(errors).toEqual([]);
  });
});

describe('an exported page whose visitor refuses', () => {
  test('the camera: says what to do, and goes on with looking around', async () => {
    const { page, errors, use } = await open({}, undefined, refusing.browser);
    await use.click();
    await page.getByRole('alert').getByText('The camera was not allowed. Allow it for this page').waitFor();
    expect(await use.isEnabled()).toBe(true);
    expect(await page.getByText('Drag to look around').isVisible()).toBe(true);
    // The picture follows in the next frame.
    await eventually(async () => {
      const [red, , blue] = pixelAt(await shot(page), 467, 240);
      expect(red - blue).toBeGreaterThan(40);
    });
    expect(errors).toEqual([]);
  });

  test('motion, as Safari asks for it in the click: shows the camera all the same', async () => {
    const { page, use } = await open({}, (opening) =>
      opening.addInitScript(() => {
        Object.defineProperty(DeviceOrientationEvent, 'requestPermission', {
          value: async () => (navigator.userActivation.isActive ? 'denied' : 'not in a click'),
        });
      }),
    );
    await use.click();
    await page.getByText('The motion sensor was not allowed').waitFor();
    await untilGreen(page);
  });

  test.each([
    ['NotFoundError', 'No camera was found. Try again on a device'],
    ['NotReadableError', 'The camera is in use or does not respond. Close other apps'],
  ])('nothing, but there is no camera to have: %s', async (name, text) => {
    const { page, use } = await open({}, (opening) =>
      opening.addInitScript((error) => {
        navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException('', error));
      }, name),
    );
    await use.click();
    await page.getByRole('alert').getByText(text).waitFor();
  });
});
