import { resolve } from 'node:path';
import { afterEach, describe, expect, test } from '@jest/globals';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { HAND_JOINTS } from '../../nodes/kit/hand-joints.ts';
import { useBrowser } from '../support/browser.ts';
import { captureHand } from '../support/captured-hand.ts';
import { pixelAt, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject, serveProjectText } from '../support/project-page.ts';
import { openXrPage, type XrPage } from './xr-page.ts';

const chromium = useBrowser();
const EXAMPLE = resolve(import.meta.dirname, '../../nodes/objects/hands/example');

const closing: { close(): Promise<void> }[] = [];
afterEach(async () => {
  for (const each of closing.splice(0).reverse()) await each.close();
});

/** Of the page, and the headset's vertical field of view. */
const SIZE = { width: 480, height: 360 };
const FOV_Y_RAD = 1.4;
const EYE = [0, 1.5, 0.5] as const;
/** Of the left hand, whose palm faces away. */
const HAND = [-0.1, 1.5, 0.15] as const;

async function enter(served: ServedExport): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, served.url, { device: 'headset', views: 1 }, SIZE);
  closing.push(served, xr);
  await xr.enter();
  await xr.setPose({ position: EYE });
  return xr;
}

/** Shows a relaxed left hand. */
async function raiseHand(xr: XrPage): Promise<void> {
  await xr.page.evaluate((at) => {
    const device = scrimEmulator?.current?.device;
    if (!device?.hands.left || !device.hands.right) throw new Error('The device has no hands.');
    device.primaryInputMode = 'hand';
    device.hands.right.connected = false;
    device.hands.left.position.set(...at);
  }, HAND);
  await xr.step(3);
}

/** The joints of that hand on the screen. */
function jointPixels(): [number, number][] {
  const { worldFromJoints } = captureHand('relaxed', HAND[0]);
  return HAND_JOINTS.map((_, i) => {
    const [x = 0, y = 0, z = 0] = worldFromJoints.slice(16 * i + 12, 16 * i + 15);
    return pixelOf([x, HAND[1] + y, HAND[2] + z]);
  });
}

/** Pixel of a point in front of a level camera. */
function pixelOf([x = 0, y = 0, z = 0]: readonly number[]): [number, number] {
  const clipFromView = projectEye('none', FOV_Y_RAD, SIZE.width / SIZE.height, 0.1, 100);
  const depthM = EYE[2] - z;
  const right = ((x - EYE[0]) * (clipFromView[0] ?? 0)) / depthM;
  const up = ((y - EYE[1]) * (clipFromView[5] ?? 0)) / depthM;
  return [Math.floor(((1 + right) / 2) * SIZE.width), Math.floor(((1 - up) / 2) * SIZE.height)];
}

const alphaAt = (picture: RgbaImage, [x, y]: readonly [number, number]) => pixelAt(picture, x, y)[3];

/** Pixels that are drawn at all. */
function drawnCount(picture: RgbaImage): number {
  let count = 0;
  for (let i = 3; i < picture.data.length; i += 4) if ((picture.data[i] ?? 0) > 127) count++;
  return count;
}

describe('an exported page with hands and controllers', () => {
  test('draws controllers at their grips, then a hand at each of its joints, then nothing', async () => {
    const xr = await enter(await serveProject(EXAMPLE));
    await xr.page.evaluate(() => {
      const { left, right } = scrimEmulator?.current?.device.controllers ?? {};
      left?.position.set(-0.2, 1.4, 0.1);
      right?.position.set(0.2, 1.4, 0.1);
    });
    await xr.step(3);
    const controllers = await xr.readLayer();
    // One in each half, and nothing between them. Their grips are behind the origins of their rays.
    expect(alphaAt(controllers, pixelOf([0, 1.4, 0.1]))).toBe(0);
    for (const x of [-0.2, 0.2]) expect(alphaAt(controllers, pixelOf([x, 1.4, 0.1]))).toBe(255);

    await raiseHand(xr);
    const hand = await xr.readLayer();
    expect(jointPixels().map((pixel) => alphaAt(hand, pixel))).toEqual(HAND_JOINTS.map(() => 255));
    // A hand of 18 cm at 35 cm, not more.
    expect(drawnCount(hand) / (SIZE.width * SIZE.height)).toBeLessThan(0.12);

    await xr.page.evaluate(() => Object.assign(scrimEmulator?.current?.device.hands.left ?? {}, { connected: false }));
    await xr.step(3);
    expect(drawnCount(await xr.readLayer())).toBe(0);
    expect(xr.errors).toEqual([]);
  });

  test('as phantoms, hands hide what is behind them', async () => {
    const wall = ['objects/primitive', { sizeM: [2, 2, 0.1] }] as const;
    const xr = await enter(
      await serveProjectText(
        {
          nodes: {
            'hands-x1': ['objects/hands', { show: 'hands' }],
            'phantom-x1': 'objects/phantom',
            'wall-x1': wall,
            'place-x1': ['objects/transform', { positionM: [0, 1.5, -1] }],
            'sun-x1': 'light/directional',
            'scene-x1': 'layer/scene',
            'screen-x1': 'output/screen',
          },
          wires: [
            'hands-x1.objects -> phantom-x1.objects',
            'wall-x1.objects -> place-x1.objects',
            'phantom-x1.objects -> scene-x1.objects',
            'place-x1.objects -> scene-x1.objects',
            'sun-x1.lights -> scene-x1.lights',
            'scene-x1.layer -> screen-x1.layer',
          ],
        },
        {},
      ),
    );
    await raiseHand(xr);
    const layer = await xr.readLayer();
    expect(jointPixels().map((pixel) => alphaAt(layer, pixel))).toEqual(HAND_JOINTS.map(() => 0));
    expect(alphaAt(layer, pixelOf([0.2, 1.5, -1]))).toBe(255);
    expect(xr.errors).toEqual([]);
  });
});
