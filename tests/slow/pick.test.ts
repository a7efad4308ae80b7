import { resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { useBrowser } from '../support/browser.ts';
import { decodeImage, pixelAt } from '../support/image.ts';
import { eventually } from '../support/patience.ts';
import { type ServedExport, serveProject, serveProjectText } from '../support/project-page.ts';
import { drawnMatrices, forgetDrawn, WATCH_MATRICES } from '../xr/drawn-matrices.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
const SIZE = { width: 480, height: 360 } as const;

/** Null while the box is not drawn. */
async function boxOf(xr: XrPage): Promise<Matrix4 | null> {
  const drawn = await drawnMatrices(xr);
  return drawn && new Matrix4().fromArray(drawn.modelViewMatrix);
}

/** The boxes are 30 cm wide. */
const scaleOf = (matrix: Matrix4 | null) => matrix && Math.round((new Vector3().setFromMatrixScale(matrix).x / 0.3) * 1e3) / 1e3;

describe('a box of a page without AR', () => {
  let served: ServedExport;
  beforeAll(async () => {
    served = await serveProject(resolve(import.meta.dirname, '../../nodes/input/pick/example'));
  });
  afterAll(() => served.close());

  test('lights up under the mouse, grows at a click, and lets no drag on it turn the view', async () => {
    const xr = await openXrPage(chromium.browser, served.url, { modes: [] }, SIZE, WATCH_MATRICES);
    const { page } = xr;
    await page.getByText('Drag to look around').waitFor();
    const area = await page.locator('canvas').boundingBox();
    if (!area) throw new Error('The page has no canvas.');
    const middle = [area.x + area.width / 2, area.y + area.height / 2] as const;
    const beside = [area.x + area.width * 0.1, area.y + area.height / 2] as const;
    /** Whether the box is orange, not blue. */
    const isLit = async () => {
      const [red, , blue] = pixelAt(decodeImage(await page.screenshot()), Math.round(middle[0]), Math.round(middle[1]));
      return red > blue;
    };
    await page.mouse.move(...beside);
    await eventually(async () => expect(await isLit()).toBe(false));
    await page.mouse.move(...middle);
    await eventually(async () => expect(await isLit()).toBe(true));
    expect(scaleOf(await boxOf(xr))).toBe(0.75);
    await page.mouse.click(...middle);
    await eventually(async () => expect(scaleOf(await boxOf(xr))).toBe(1.25));
    const drag = async (from: readonly [number, number]) => {
      await page.mouse.move(...from);
      await page.mouse.down();
      await page.mouse.move(from[0] + 80, from[1] + 10, { steps: 4 });
      await page.mouse.up();
    };
    const before = await boxOf(xr);
    await drag(middle);
    // A drag is no tap.
    await page.mouse.move(...beside);
    await eventually(async () => expect(await isLit()).toBe(false));
    expect(await boxOf(xr)).toEqual(before);
    await drag(beside);
    await eventually(async () => expect(await boxOf(xr)).not.toEqual(before));
    expect(xr.errors).toEqual([]);
    await xr.close();
  });
});

describe('a box that a visitor of a phone has placed', () => {
  let served: ServedExport;
  beforeAll(async () => {
    served = await serveProjectText(
      {
        nodes: {
          'box-x1': ['objects/primitive', { sizeM: [0.3, 0.3, 0.3] }],
          'grow-x1': ['objects/transform', { scale: { port: 1 } }],
          'place-x1': ['objects/place', { reticle: false }],
          'pick-x1': 'input/pick',
          'counter-x1': ['value/counter', { start: 1, step: 0.5 }],
          'scene-x1': 'layer/scene',
          'sun-x1': 'light/directional',
          'screen-x1': 'output/screen',
        },
        wires: [
          'box-x1.objects -> grow-x1.objects',
          'grow-x1.objects -> place-x1.objects',
          'place-x1.objects -> pick-x1.objects',
          'pick-x1.tapped -> counter-x1.up',
          'counter-x1.number -> grow-x1.scale',
          'place-x1.objects -> scene-x1.objects',
          'sun-x1.lights -> scene-x1.lights',
          'scene-x1.layer -> screen-x1.layer',
        ],
      },
      {},
    );
  });
  afterAll(() => served.close());

  test('grows at a tap on it, moves at a drag, and moves at a tap on the floor', async () => {
    const xr = await openXrPage(chromium.browser, served.url, { device: 'phone', room: 'studio' }, SIZE, WATCH_MATRICES);
    const pitchRad = 0.7;
    await xr.setPose({ position: [0, 1.5, 1], quaternion: [-Math.sin(pitchRad / 2), 0, 0, Math.cos(pitchRad / 2)] });
    await xr.enter();
    await xr.step(2);
    // The materials of hidden objects are compiled by a draw before the first frame.
    await forgetDrawn(xr);
    await xr.step(2);
    /** Scale, and where the center of the box is on the screen, from the left and the top. */
    const seen = async () => {
      const drawn = await boxOf(xr);
      if (!drawn) return null;
      const { x, y, z } = new Vector3().setFromMatrixPosition(drawn);
      const tan = Math.tan((await xr.page.evaluate(() => scrimEmulator?.current?.device.fovy ?? 0)) / 2);
      return { scale: scaleOf(drawn), x: 0.5 + x / -z / tan / (SIZE.width / SIZE.height) / 2, y: 0.5 - y / -z / tan / 2 };
    };
    const at = (x: number, y: number, scale: number) => ({ scale, x: expect.closeTo(x, 2), y: expect.closeTo(y, 2) });
    expect(await seen()).toBe(null);
    // The tap that places the box is none on it.
    await xr.touch([0.5, 0.55]);
    expect(await seen()).toEqual(at(0.5, 0.55, 1));
    await xr.touch([0.5, 0.54]);
    expect(await seen()).toEqual(at(0.5, 0.55, 1.5));
    await xr.touch([0.5, 0.55], [0.4, 0.6], [0.3, 0.7]);
    expect(await seen()).toEqual(at(0.3, 0.7, 1.5));
    await xr.touch([0.8, 0.4]);
    expect(await seen()).toEqual(at(0.8, 0.4, 1.5));
    await xr.touch([0.8, 0.4]);
    expect(await seen()).toEqual(at(0.8, 0.4, 2));
    expect(xr.errors).toEqual([]);
    await xr.close();
  });
});
