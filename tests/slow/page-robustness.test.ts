import { resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { Program } from '../../export/program/program.ts';
import { LAMP } from '../browser/controls-program.ts';
import { type ServedPage, servePage } from '../browser/page-kit.ts';
import { collectErrors, drawPageSeldom, useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { aliveGl, watchGl } from '../xr/count-gl.ts';
import { openXrPage, readCapture, type XrPage } from '../xr/xr-page.ts';

const [lamp] = LAMP.operations;
const [lampShader] = LAMP.shaders;
if (lamp?.kind !== 'pass' || !lampShader) throw new Error('The lamp is one pass.');

/** The lamp, which tells the time: seconds in green, their 256ths in blue. It is red until the mood is set to cold. */
const CLOCK: Program = {
  ...LAMP,
  title: 'Clock',
  operations: [{ ...lamp, uniforms: [...lamp.uniforms, { name: 'seconds', type: 'float', source: { builtin: 'TIME' } }] }],
  shaders: [
    {
      ...lampShader,
      id: 'clock',
      fragment: lampShader.fragment
        .replace('uniform float mood;', 'uniform float mood;\nuniform float seconds;')
        .replace(
          /color = .*\n/,
          'color = vec4(mood < 0.5 ? 1.0 : 0.0, floor(mod(seconds, 256.0)) / 255.0, floor(fract(seconds) * 256.0) / 255.0, 1.0) * a;\n',
        ),
    },
  ],
};

/** Few, so that seconds of waiting are few frames. */
const FRAMES_PER_SECOND = 30;

/** Of the frame that is shown, at a pixel of the lamp. */
const secondsOf = ([, green = 0, blue = 0]: readonly number[]) => green + blue / 256;
const moodOf = ([red = 0]: readonly number[]) => (red > 128 ? 'warm' : 'cold');

const chromium = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);
const livingRoom = await readCapture('living_room');
let served: ServedPage;
let robots: ServedExport;
beforeAll(async () => {
  served = await servePage(CLOCK);
  robots = await serveProject(resolve(import.meta.dirname, '../../examples/first-light'), { compress: false });
});
afterAll(async () => {
  await served.close();
  await robots.close();
});

const opened: { close(): Promise<void> }[] = [];
afterEach(async () => {
  for (const page of opened.splice(0)) await page.close();
});

async function open(options: EmulatorOptions, url = served.url, viewport?: { width: number; height: number }): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, url, options, viewport);
  opened.push(xr);
  return xr;
}

/** The middle of a view. */
function middle({ width, height, ...picture }: RgbaImage, view = 0, views = 1): readonly number[] {
  return pixelAt({ width, height, ...picture }, Math.floor((width / views) * (view + 0.5)), Math.floor(height / 2));
}

/** The share of a layer in which there is anything. */
function covered({ data }: RgbaImage): number {
  let count = 0;
  for (let i = 3; i < data.length; i += 4) if ((data[i] ?? 0) > 0) count++;
  return count / (data.length / 4);
}

/** Takes the graphics from the page's own canvas, or gives them back. */
async function graphics(page: Page, what: 'loseContext' | 'restoreContext'): Promise<void> {
  await page.evaluate((method) => {
    const canvas = document.querySelector('canvas');
    const kept = window as unknown as { lost?: WEBGL_lose_context | null };
    // While it is lost, nothing can be asked of it.
    kept.lost ??= canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context') ?? null;
    kept.lost?.[method]();
  }, what);
}

describe.each([
  ['phone', 1],
  ['headset', 2],
] as const)('a session of an exported page on a %s', (device, views) => {
  const options: EmulatorOptions = { device, room: livingRoom, framesPerSecond: FRAMES_PER_SECOND };
  /** Seconds of the device's time. */
  const wait = (xr: XrPage, seconds: number) => xr.step(seconds * FRAMES_PER_SECOND);

  test('goes on where it was when the device was lost for a while, or the session hidden', async () => {
    const xr = await open(options);
    await xr.enter();
    const now = async () => secondsOf(middle(await xr.readLayer(), 0, views));
    const began = await now();
    await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(false));
    await xr.step(2);
    await xr.page.getByRole('status').getByText('Looking for the room').waitFor();
    // Of which half a second counts.
    await wait(xr, 4);
    await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(true));
    await xr.step(2);
    await xr.page.getByText('Looking for the room').waitFor({ state: 'detached' });
    const found = await now();
    expect(found - began).toBeGreaterThan(0);
    expect(found - began).toBeLessThan(0.6);

    // Behind a menu of the system it is still seen, and goes on.
    await xr.page.evaluate(() => scrimEmulator?.current?.setVisibility('visible-blurred'));
    await wait(xr, 0.5);
    const blurred = await now();
    expect(blurred - found).toBeCloseTo(0.5, 1);
    await xr.page.evaluate(() => scrimEmulator?.current?.setVisibility('hidden'));
    await wait(xr, 4);
    await xr.page.evaluate(() => scrimEmulator?.current?.setVisibility('visible'));
    await xr.step(2);
    expect((await now()) - blurred).toBeLessThan(0.6);
    expect(moodOf(middle(await xr.readLayer(), views - 1, views))).toBe('warm');
    expect(xr.errors).toEqual([]);
  });

  test('fills its framebuffer whatever becomes of its size', async () => {
    const xr = await open(options);
    await xr.enter();
    for (const [width, height] of [
      [200 * views, 420],
      [420 * views, 200],
      [64 * views, 64],
    ] as const) {
      await xr.page.evaluate((size) => scrimEmulator?.current?.setSize(size), [width, height] as const);
      await xr.step(2);
      const layer = await xr.readLayer();
      expect([layer.width, layer.height]).toEqual([width, height]);
      // The lamp's radius is 0.3 of the shorter side, in the middle of each view.
      const radius = 0.3 * Math.min(width / views, height);
      for (let view = 0; view < views; view++) {
        const x = Math.floor((width / views) * (view + 0.5));
        const at = (dx: number) => pixelAt(layer, Math.round(x + dx), Math.floor(height / 2))[3];
        expect([at(0), at(radius - 3), at(3 - radius), at(radius + 3), at(-3 - radius)]).toEqual([255, 255, 255, 0, 0]);
      }
    }
    expect(xr.errors).toEqual([]);
  });

  test('outlives its graphics, twice: says so, and comes back with what was set', async () => {
    const xr = await open(options);
    // Folded on a window as narrow as this.
    await xr.page.getByRole('button', { name: 'Controls' }).click();
    await xr.page.getByRole('radio', { name: 'Cold' }).click();
    await xr.enter();
    const before = await xr.readLayer();
    let last = secondsOf(middle(before, 0, views));
    for (let i = 0; i < 2; i++) {
      await graphics(xr.page, 'loseContext');
      await xr.page.getByRole('alert').getByText('Graphics were interrupted').waitFor();
      await wait(xr, 2);
      await graphics(xr.page, 'restoreContext');
      await xr.page.getByText('Graphics were interrupted').waitFor({ state: 'detached' });
      await xr.step(3);
      const after = await xr.readLayer();
      expect([after.width, after.height]).toEqual([before.width, before.height]);
      expect(moodOf(middle(after, views - 1, views))).toBe('cold');
      // The lamp, and the panel of the controls where the device hides the page.
      expect(Math.abs(covered(after) - covered(before))).toBeLessThan(0.002);
      const seconds = secondsOf(middle(after, 0, views));
      expect(seconds - last).toBeGreaterThan(0);
      expect(seconds - last).toBeLessThan(0.7);
      last = seconds;
    }
    // Still the session that the visitor began.
    expect(await xr.page.getByRole('button', { name: 'Enter AR' }).isVisible()).toBe(false);
    await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
    await xr.page.getByText('AR has ended').waitFor();
    expect(xr.errors).toEqual([]);
  });
});

describe('a page with models', () => {
  test('draws them again in the same session when the graphics are back', async () => {
    const xr = await open({ device: 'headset', room: livingRoom }, robots.url);
    await xr.setPose({ position: [0, 1.5, 1.5] });
    await xr.enter();
    const before = covered(await xr.readLayer());
    expect(before).toBeGreaterThan(0.01);
    await graphics(xr.page, 'loseContext');
    await xr.page.getByText('Graphics were interrupted').waitFor();
    await xr.step(2);
    await graphics(xr.page, 'restoreContext');
    await xr.page.getByText('Graphics were interrupted').waitFor({ state: 'detached' });
    await xr.step(3);
    expect(Math.abs(covered(await xr.readLayer()) - before)).toBeLessThan(0.1 * before);
    expect(xr.errors).toEqual([]);
  });

  test('holds as many GPU objects after eight AR sessions as after one, whether page or device ended them', async () => {
    const xr = await open({ device: 'phone', room: livingRoom }, robots.url, { width: 240, height: 180 });
    await xr.page.getByRole('button', { name: 'Enter AR' }).waitFor();
    await watchGl(xr.page);
    const alive: number[] = [];
    for (let i = 0; i < 8; i++) {
      await xr.enter();
      if (i % 2 === 0) await xr.page.getByRole('button', { name: 'Leave AR' }).click();
      else await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
      await xr.page.getByRole('button', { name: 'Enter AR' }).waitFor();
      alive.push(await aliveGl(xr.page));
    }
    expect(alive).toEqual(alive.map(() => alive[0]));
    expect(xr.errors).toEqual([]);
  });
});

describe('a page that is looked at without AR', () => {
  /** A window whose clock can be set on, as it is found when it was hidden for that long. */
  async function openLapsing(viewport = { width: 1280, height: 720 }) {
    const page = await chromium.browser.newPage({ viewport });
    opened.push(page);
    const errors = collectErrors(page);
    await drawPageSeldom(page);
    await page.addInitScript(() => {
      const request = window.requestAnimationFrame.bind(window);
      Object.assign(window, { awayMs: 0 });
      window.requestAnimationFrame = (callback) => request((timeMs) => callback(timeMs + (window as unknown as { awayMs: number }).awayMs));
    });
    await page.goto(served.url);
    await page.getByText('look around').waitFor();
    return { page, errors };
  }
  const shot = async (page: Page) => decodeImage(await page.screenshot());
  const nowOf = async (page: Page) => secondsOf(middle(await shot(page)));

  test.each([
    ['around', null],
    ['through the camera', 'Use the camera'],
  ])('goes on where it was after two minutes away: %s', async (_how, button) => {
    const { page, errors } = await openLapsing();
    if (button !== null) {
      await page.getByRole('button', { name: button }).click();
      await page.getByRole('button', { name: 'Stop the camera' }).waitFor();
    }
    const before = await nowOf(page);
    // Its time runs.
    for (let now = before; now <= before; ) now = await nowOf(page);
    await page.evaluate(() => Object.assign(window, { awayMs: 120_000 }));
    const seen = await nowOf(page);
    for (let now = seen; now <= seen; ) now = await nowOf(page);
    expect((await nowOf(page)) - before).toBeLessThan(100);
    expect(errors).toEqual([]);
  });

  test('fits its window as that changes', async () => {
    const { page, errors } = await openLapsing();
    // Open since the window was wide, they would cover a narrow one.
    await page.getByRole('button', { name: 'Controls' }).click();
    for (const [width, height] of [
      [390, 844],
      [1000, 600],
      [1600, 900],
    ] as const) {
      await page.setViewportSize({ width, height });
      // The folded card lies below the middle of a phone held upright.
      const sizeOf = () =>
        page.evaluate(() => {
          const { width = 0, height = 0, clientWidth, clientHeight } = document.querySelector('canvas') ?? {};
          return [width, height, clientWidth, clientHeight] as const;
        });
      let size = await sizeOf();
      while (size[0] !== width || size[0] !== size[2] || size[1] !== size[3]) size = await sizeOf();
      expect(moodOf(pixelAt(await shot(page), size[0] / 2, Math.floor(size[1] / 2)))).toBe('warm');
    }
    expect(errors).toEqual([]);
  });
});
