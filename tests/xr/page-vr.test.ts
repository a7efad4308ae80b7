import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { LAMP } from '../browser/controls-program.ts';
import { type ServedPage, servePage } from '../browser/page-kit.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { aliveGl, watchGl } from './count-gl.ts';
import { openXrPage, type XrPage } from './xr-page.ts';

const PROGRAM: Program = {
  ...LAMP,
  tiers: [...LAMP.tiers, { id: 'authored-vr', without: [{ capability: 'depth', effect: 'it shines through everything' }] }],
};

const chromium = useBrowser();
let served: ServedPage;
beforeAll(async () => {
  served = await servePage(PROGRAM);
});
afterAll(() => served.close());

let opened: XrPage | null = null;
afterEach(async () => {
  await opened?.close();
  opened = null;
});

/** As visionOS has it: VR and no AR. */
async function open(): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, served.url, { device: 'headset', modes: ['immersive-vr'] }, { width: 960, height: 480 });
  opened = xr;
  return xr;
}

async function enter({ page, setPose }: XrPage): Promise<void> {
  await setPose({ position: [0, 1.6, 0] });
  await page.getByRole('button', { name: 'Enter VR' }).click();
  await page.evaluate(() => scrimEmulator?.current?.frameRequested());
  await page.evaluate(() => scrimEmulator?.current?.stepFrame(3));
}

/** At a fraction of one eye's view, from its top left. */
function seen(layer: RgbaImage, view: 0 | 1, x: number, y: number): readonly number[] {
  return pixelAt(layer, Math.floor((view + x) * (layer.width / 2)), Math.floor(y * layer.height));
}

describe('VR, on a headset that has no AR', () => {
  test('is a plain room, after saying what will be asked and what is missing: floor, horizon, sky, and the picture before them', async () => {
    const xr = await open();
    const button = xr.page.getByRole('button', { name: 'Enter VR' });
    await button.waitFor();
    expect(await xr.page.getByRole('button', { name: 'Enter AR' }).isVisible()).toBe(false);
    const about = await xr.page.locator(`#${await button.getAttribute('aria-describedby')}`).textContent();
    expect(about).toContain('You see a plain room instead of your own.');
    expect(about).toContain('It shines through everything.');

    await enter(xr);
    const layer = await xr.readLayer();
    for (const view of [0, 1] as const) {
      // Nothing is left empty: a hole would be black.
      for (const [x, y] of [
        [0.02, 0.02],
        [0.98, 0.02],
        [0.05, 0.5],
        [0.95, 0.5],
        [0.02, 0.98],
        [0.98, 0.98],
      ] as const) {
        const [red = 0, green = 0, blue = 0, alpha] = seen(layer, view, x, y);
        expect(Math.min(red, green, blue)).toBeGreaterThan(100);
        expect(alpha).toBe(255);
      }
      const [skyRed = 0, , skyBlue = 0] = seen(layer, view, 0.05, 0.02);
      const [floorRed = 0, , floorBlue = 0] = seen(layer, view, 0.05, 0.98);
      const [horizonRed = 0] = seen(layer, view, 0.05, 0.5);
      expect(skyBlue - skyRed).toBeGreaterThan(15);
      expect(Math.abs(floorBlue - floorRed)).toBeLessThan(10);
      expect(horizonRed).toBeGreaterThan(Math.max(skyRed, floorRed) + 15);
      expect(seen(layer, view, 0.5, 0.45)).toEqual([255, 0, 0, 255]);
    }
    // A view upwards shows no floor.
    await xr.setPose({ position: [0, 1.6, 0], quaternion: [Math.SQRT1_2, 0, 0, Math.SQRT1_2] });
    await xr.step(2);
    const [upRed = 0, , upBlue = 0] = seen(await xr.readLayer(), 0, 0.05, 0.98);
    expect(upBlue - upRed).toBeGreaterThan(5);
    expect(xr.errors).toEqual([]);
  });

  test('is left and entered repeatedly without leaks', async () => {
    const xr = await open();
    await xr.page.getByRole('button', { name: 'Enter VR' }).waitFor();
    await watchGl(xr.page);
    const alive: number[] = [];
    for (let i = 0; i < 3; i++) {
      await enter(xr);
      await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
      await xr.page.getByText('VR has ended').waitFor();
      alive.push(await aliveGl(xr.page));
    }
    expect(alive).toEqual(alive.map(() => alive[0]));
    expect(xr.errors).toEqual([]);
  });

  test('is not offered where AR can be had, nor where the picture cannot do with it', async () => {
    opened = await openXrPage(chromium.browser, served.url, { device: 'headset' });
    await opened.page.getByRole('button', { name: 'Enter AR' }).waitFor();
    expect(await opened.page.getByRole('button', { name: 'Enter VR' }).isVisible()).toBe(false);
    await opened.close();
    const without = await servePage(LAMP);
    opened = await openXrPage(chromium.browser, without.url, { device: 'headset', modes: ['immersive-vr'] });
    await opened.page.getByText('look around').waitFor();
    expect(await opened.page.getByRole('button', { name: 'Enter VR' }).isVisible()).toBe(false);
    await without.close();
  });
});
