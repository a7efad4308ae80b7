import { resolve } from 'node:path';
import { afterEach, expect, test } from '@jest/globals';
import { useBrowser } from '../support/browser.ts';
import { pixelAt } from '../support/image.ts';
import { serveProject } from '../support/project-page.ts';
import { type IwerPage, type IwerView, openIwerPage } from './iwer-page.ts';

/** An exported page in the emulator that browsers' extensions are built on, as it comes, in a room of its own. */

const chromium = useBrowser();
const EXAMPLE = resolve(import.meta.dirname, '../../nodes/objects/place/example');

const closing: (() => Promise<unknown>)[] = [];
afterEach(async () => {
  for (const close of closing.splice(0).reverse()) await close();
});

/** Where the controller is held, and the point of the floor that it points at, straight ahead: meters. */
const HAND = [0.2, 1.2, -0.2] as const;
const AHEAD_M = 1.2;
const FLOOR_POINT = [HAND[0], 0, HAND[2] - AHEAD_M] as const;
/** Of the example's robot, from its foot to the top of its head, and its widest part. */
const HEIGHT_M = 0.72;
const WIDTH_M = 0.3;

async function pull(iwer: IwerPage, value: number): Promise<void> {
  await iwer.page.evaluate((to) => testIwer?.device.controllers.right?.updateButtonValue('trigger', to), value);
  await iwer.nextFrame();
}

/** Pixel of a point of the room in one eye's part of the layer, from the top left. */
function pixelOf({ viewport, clipFromView, worldFromView: w }: IwerView, point: readonly number[]): [number, number] {
  const from = [0, 1, 2].map((i) => (point[i] ?? 0) - (w[12 + i] ?? 0));
  const inView = [0, 1, 2].map((axis) => from.reduce((sum, x, i) => sum + x * (w[4 * axis + i] ?? 0), 0));
  const [x = 0, y = 0, z = 0] = inView;
  const p = (i: number) => clipFromView[i] ?? 0;
  const ndc = [(p(0) * x + p(8) * z) / -z, (p(5) * y + p(9) * z) / -z] as const;
  return [viewport.x + ((1 + ndc[0]) / 2) * viewport.width, ((1 - ndc[1]) / 2) * viewport.height];
}

test('a tap by a controller places the robot on the floor of iwer’s room, where the controller points', async () => {
  const served = await serveProject(EXAMPLE);
  closing.push(served.close);
  const iwer = await openIwerPage(
    chromium.browser,
    served.url,
    { room: 'living_room', mode: 'immersive-ar', position: [0, 1.5, 0.6], quaternion: [-0.2, 0, 0, 0.98] },
    { width: 640, height: 400 },
  );
  closing.push(iwer.close);
  await iwer.page.getByRole('button', { name: 'Enter AR' }).click();
  await iwer.nextFrame();
  await iwer.page.evaluate(
    ({ hand, pitchRad }) => {
      const controller = testIwer?.device.controllers.right;
      controller?.position.set(...hand);
      controller?.quaternion.set(-Math.sin(pitchRad / 2), 0, 0, Math.cos(pitchRad / 2));
    },
    { hand: HAND, pitchRad: Math.atan2(HAND[1], AHEAD_M) },
  );
  await iwer.nextFrame();
  await pull(iwer, 1);
  await pull(iwer, 0);
  const { layer, views } = await iwer.nextFrame();
  expect(views).toHaveLength(2);
  for (const view of views) {
    const [left, right, top, bottom] = extentOf(layer, view);
    const foot = pixelOf(view, FLOOR_POINT);
    const head = pixelOf(view, [FLOOR_POINT[0], HEIGHT_M, FLOOR_POINT[2]]);
    const perMeter = (foot[1] - head[1]) / HEIGHT_M;
    // The robot's middle is above the point; its foot reaches 12 cm towards the visitor.
    expect(Math.abs((left + right) / 2 - foot[0])).toBeLessThan(0.05 * perMeter);
    expect(bottom - foot[1]).toBeGreaterThan(0);
    expect(bottom - foot[1]).toBeLessThan(0.15 * perMeter);
    expect(Math.abs(top - head[1])).toBeLessThan(0.08 * perMeter);
    expect((right - left) / perMeter / WIDTH_M).toBeCloseTo(1.1, 0);
  }
  expect(iwer.errors).toEqual([]);
});

/** Of what is drawn in one eye's part: left, right, top, bottom, pixels. */
function extentOf(layer: { readonly width: number; readonly height: number; readonly data: Uint8Array }, { viewport }: IwerView) {
  const box: [number, number, number, number] = [Number.POSITIVE_INFINITY, -1, Number.POSITIVE_INFINITY, -1];
  for (let y = 0; y < viewport.height; y++) {
    for (let x = viewport.x; x < viewport.x + viewport.width; x++) {
      if (pixelAt(layer, x, y)[3] < 128) continue;
      box[0] = Math.min(box[0], x);
      box[1] = Math.max(box[1], x + 1);
      box[2] = Math.min(box[2], y);
      box[3] = Math.max(box[3], y + 1);
    }
  }
  return box;
}
