import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { DISC, type ServedPage, servePage } from '../browser/page-kit.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { openXrPage, readCapture, type XrPage } from './xr-page.ts';

// With a camera, for those whom AR refuses.
const chromium = useBrowser(['--use-fake-device-for-media-stream', '--use-fake-ui-for-media-stream']);
const livingRoom = await readCapture('living_room');
let served: ServedPage;
beforeAll(async () => {
  served = await servePage(DISC);
});
afterAll(() => served.close());

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

async function open(options: EmulatorOptions = {}): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, served.url, { room: livingRoom, ...options });
  opened.push(xr);
  return xr;
}

/** Whether the disc of the test's program is where it belongs in the part of the layer that one view covers. */
function showsDisc(layer: RgbaImage, fromX: number, toX: number): boolean {
  const [red, , , alpha] = pixelAt(layer, Math.floor((fromX + toX) / 2), Math.floor(layer.height / 2));
  const corner = pixelAt(layer, fromX + 2, 2);
  return red > 200 && alpha === 255 && corner[3] === 0;
}

describe('an exported page with AR', () => {
  test('says what will be asked for, and why, before anything is asked', async () => {
    const { page, errors } = await open();
    const button = page.getByRole('button', { name: 'Enter AR' });
    await button.waitFor();
    expect(await page.evaluate(() => scrimEmulator?.current?.device.activeSession)).toBeFalsy();
    const described = await button.getAttribute('aria-describedby');
    const text = (await page.locator(`#${described}`).textContent()) ?? '';
    expect(text).toContain('track how your device moves');
    expect(text).toContain('To hide the light behind furniture. Without it: it shines through everything.');
    expect(text).toContain('To tint the room.');
    expect(errors).toEqual([]);
  });

  test.each([
    ['one view', 'phone', 1],
    ['two views', 'headset', 2],
  ] as const)('draws into the session, over the room: %s', async (_name, device, views) => {
    const xr = await open({ device, extra: ['camera-access'] });
    await xr.enter();
    const layer = await xr.readLayer();
    const viewWidth = layer.width / views;
    for (let view = 0; view < views; view++) expect(showsDisc(layer, view * viewWidth, (view + 1) * viewWidth)).toBe(true);
    const composite = await xr.readComposite();
    expect(pixelAt(composite, 2, 2).slice(0, 3)).not.toEqual([0, 0, 0]);
    expect(xr.errors).toEqual([]);
  });

  test('is left by its own button repeatedly, and shows the orbit view each time', async () => {
    const xr = await open();
    for (let i = 0; i < 5; i++) {
      await xr.enter();
      expect(await xr.page.getByRole('heading', { name: 'Warm light' }).isVisible()).toBe(false);
      await xr.page.getByRole('button', { name: 'Leave AR' }).click();
      await xr.page.getByRole('button', { name: 'Enter AR' }).waitFor();
      expect(await xr.page.evaluate(() => document.activeElement?.textContent)).toBe('Enter AR');
      expect(await xr.page.getByText('Drag to look around').isVisible()).toBe(true);
    }
    await xr.enter();
    expect(showsDisc(await xr.readLayer(), 0, 480)).toBe(true);
    expect(xr.errors).toEqual([]);
  });

  test('is left by its own button on a phone held upright, too', async () => {
    const xr = await openXrPage(chromium.browser, served.url, { room: livingRoom }, { width: 390, height: 844 });
    opened.push(xr);
    await xr.enter();
    await xr.page.getByRole('button', { name: 'Leave AR' }).click();
    await xr.page.getByRole('button', { name: 'Enter AR' }).waitFor();
    expect(xr.errors).toEqual([]);
  });

  test('says that AR has ended when the system ends it, and can be entered again', async () => {
    const xr = await open();
    await xr.enter();
    await xr.page.evaluate(() => scrimEmulator?.current?.endSession());
    await xr.page.getByText('AR has ended').waitFor();
    await xr.enter();
    expect(await xr.page.getByText('AR has ended').count()).toBe(0);
    expect(xr.errors).toEqual([]);
  });

  test('says what the picture does without what the device lacks', async () => {
    const xr = await open({ refuse: ['depth-sensing'] });
    await xr.enter();
    await xr.page.getByRole('status').getByText('it shines through everything').waitFor();
    expect(xr.errors).toEqual([]);
  });

  test('says when it does not know where it is', async () => {
    const xr = await open();
    await xr.enter();
    await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(false));
    await xr.step(2);
    await xr.page.getByText('Looking for the room').waitFor();
    await xr.page.evaluate(() => scrimEmulator?.current?.setTracked(true));
    await xr.step(2);
    await xr.page.getByText('Looking for the room').waitFor({ state: 'detached' });
  });

  test('says why when the visitor refuses', async () => {
    const xr = await open();
    await xr.page.evaluate(() => {
      const { xr: system } = navigator;
      Object.defineProperty(system, 'requestSession', { value: () => Promise.reject(new DOMException('', 'NotAllowedError')) });
    });
    await xr.page.getByRole('button', { name: 'Enter AR' }).click();
    await xr.page.getByRole('alert').getByText('AR was not allowed. Try again').waitFor();
    expect(await xr.page.getByRole('button', { name: 'Enter AR' }).isEnabled()).toBe(true);
    expect(xr.errors).toEqual([]);
  });

  test('offers the next ways in where the headset has no camera access and nothing is left without it', async () => {
    const needsCamera = {
      ...DISC,
      needs: DISC.needs.map((need) => (need.capability === 'camera-image' ? { ...need, required: true } : need)),
    };
    const only = await servePage({ ...needsCamera, tiers: [...DISC.tiers, { id: 'authored-vr', without: [] }] });
    const xr = await openXrPage(chromium.browser, only.url, { device: 'headset' });
    opened.push(xr);
    await xr.page.getByRole('button', { name: 'Enter AR' }).click();
    await xr.page.getByRole('alert').getByText('lacks what the page needs: the camera feed').waitFor();
    expect(await xr.page.getByRole('button', { name: 'Use the camera' }).isVisible()).toBe(true);
    await xr.page.getByRole('button', { name: 'Enter VR' }).click();
    await xr.page.evaluate(() => scrimEmulator?.current?.frameRequested());
    await xr.page.evaluate(() => scrimEmulator?.current?.stepFrame(2));
    expect(pixelAt(await xr.readLayer(), 5, 5)[3]).toBe(255);
    expect(xr.errors).toEqual([]);
    await only.close();
  });

  test('offers the camera where AR was refused, and AR still', async () => {
    const xr = await open();
    const camera = xr.page.getByRole('button', { name: 'Use the camera' });
    expect(await camera.isVisible()).toBe(false);
    await xr.page.evaluate(() => {
      Object.defineProperty(navigator.xr, 'requestSession', {
        value: () => Promise.reject(new DOMException('', 'NotSupportedError')),
      });
    });
    await xr.page.getByRole('button', { name: 'Enter AR' }).click();
    await xr.page.getByRole('alert').getByText('This device has no AR').waitFor();
    await camera.click();
    await xr.page.getByRole('button', { name: 'Stop the camera' }).waitFor();
    expect(await xr.page.getByText('This device has no AR').count()).toBe(0);
    expect(xr.errors).toEqual([]);
  });
});
