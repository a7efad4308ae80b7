import { resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { useBrowser } from '../support/browser.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProject(resolve(import.meta.dirname, '../../nodes/world/hit-test/example'));
});
afterAll(() => served.close());

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

const SIZE = { width: 480, height: 360 };
/** Of a phone. */
const FOV_Y_RAD = 1.05;
/** Of the example's ring. */
const RADIUS_M = 0.125;

/** Keeps what the page asks a session for. */
const SPY = `
  const request = navigator.xr.requestSession.bind(navigator.xr);
  navigator.xr.requestSession = (mode, init) => { globalThis.asked = init; return request(mode, init); };
`;

async function enter(options: EmulatorOptions): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, served.url, { device: 'phone', room: 'studio', ...options }, SIZE, SPY);
  opened.push(xr);
  await xr.enter();
  return xr;
}

/** Looks from `eye` down by `pitchRad`. */
async function look(xr: XrPage, eye: readonly [number, number, number], pitchRad: number): Promise<RgbaImage> {
  await xr.setPose({ position: eye, quaternion: [-Math.sin(pitchRad / 2), 0, 0, Math.cos(pitchRad / 2)] });
  await xr.step(3);
  return xr.readLayer();
}

/** The box around everything that the page drew, pixels from the top left; null for nothing. */
function drawn(picture: RgbaImage) {
  const box = { left: Number.POSITIVE_INFINITY, right: -1, top: Number.POSITIVE_INFINITY, bottom: -1 };
  for (let y = 0; y < picture.height; y++) {
    for (let x = 0; x < picture.width; x++) {
      if (pixelAt(picture, x, y)[3] < 128) continue;
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x + 1);
      box.top = Math.min(box.top, y);
      box.bottom = Math.max(box.bottom, y + 1);
    }
  }
  return box.right < 0 ? null : box;
}

describe('an exported page with a hit test', () => {
  test('asks for hit tests as an option, and for nothing else', async () => {
    const xr = await enter({});
    const asked = await xr.page.evaluate(() => (globalThis as unknown as { asked: XRSessionInit }).asked);
    expect(asked).toMatchObject({ requiredFeatures: [], optionalFeatures: ['local-floor', 'hit-test', 'dom-overlay'] });
    expect(asked).not.toHaveProperty('depthSensing');
  });

  test.each([
    ['by the device', {}],
    ['by an assumed floor', { refuse: ['hit-test'] }],
  ])('lays its ring on the floor where the view meets it, %s', async (_name, options) => {
    const xr = await enter(options);
    for (const [eye, pitch] of [
      [[0.4, 1.5, 1.2], 0.9],
      [[-0.5, 1.7, 1.4], 1.1],
    ] as const) {
      const picture = await look(xr, eye, pitch);
      const box = drawn(picture);
      if (!box) throw new Error('Nothing was drawn.');
      // The ring's sides are as far away as its middle, where the view's axis meets the floor.
      const distanceM = eye[1] / Math.sin(pitch);
      const clipFromView = projectEye('none', FOV_Y_RAD, picture.width / picture.height, 0.1, 100);
      const halfPx = ((RADIUS_M * (clipFromView[0] ?? 0)) / distanceM / 2) * picture.width;
      expect((box.left + box.right) / 2).toBeCloseTo(picture.width / 2, -0.5);
      // A torus reaches above the floor by a fifth of its size, and is nearer on the visitor's side: two pixels.
      expect(Math.abs((box.right - box.left) / 2 - halfPx)).toBeLessThan(2);
      // Its hole is where the view's middle is.
      expect(pixelAt(picture, picture.width / 2, picture.height / 2)[3]).toBe(0);
    }
    expect(xr.errors).toEqual([]);
  });

  test('hides the ring where the view meets nothing', async () => {
    const xr = await enter({ refuse: ['hit-test'] });
    expect(drawn(await look(xr, [0, 1.5, 1], -0.5))).toBe(null);
    expect(drawn(await look(xr, [0, 1.5, 1], 0.9))).not.toBe(null);
  });
});
