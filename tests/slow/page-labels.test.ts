import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import { decodeImage, encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { OUTPUT_FOLDER } from '../support/this-test.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const SIZE = { width: 640, height: 480 };
/** Of a phone. */
const FOV_Y_RAD = 1.05;
const FONT_M = 0.12;
const FONT_PX = 32;
const AT = new Vector3(0, 1.3, 0);

/** A magenta card, which nothing in the room is like. */
const CARD = {
  a: 1.2,
  b: 0.0142,
  background: [1, 0, 1, 1],
  icon: 'ruler',
  sizeM: FONT_M,
  text: '{a:2 m} ± {b:2 m}\\n שלום',
  title: '<b>Distance</b>',
};

const ANGLES: readonly (readonly [name: string, eye: readonly [number, number, number]])[] = [
  ['front', [0, 1.3, 1.6]],
  ['left', [-1.3, 1.4, 1.1]],
  ['right', [1.3, 1.2, 1.1]],
  ['above', [0.2, 2.2, 1.1]],
  ['below', [-0.4, 0.5, 1.3]],
  ['far', [0.8, 1.7, 2.4]],
];

function project(params: Readonly<Record<string, unknown>>) {
  return {
    nodes: {
      'pose-x1': ['pose/from-values', { positionM: AT.toArray() }] as const,
      'label-x1': ['objects/label', { ...CARD, fade: false, ...params }] as const,
      'scene-x1': 'layer/scene',
      'screen-x1': 'output/screen',
    },
    wires: ['pose-x1.pose -> label-x1.pose', 'label-x1.objects -> scene-x1.objects', 'scene-x1.layer -> screen-x1.layer'],
  };
}

const chromium = useBrowser();
const served: Record<string, ServedExport> = {};
beforeAll(async () => {
  const fixed = { facing: 'pose', liftM: 0 };
  served.page = await serveProjectText(project(fixed), {});
  served.scene = await serveProjectText(project({ ...fixed, where: 'scene' }), {});
  served.ledPage = await serveProjectText(project({ liftM: 0.2 }), {});
  served.ledScene = await serveProjectText(project({ liftM: 0.2, where: 'scene' }), {});
});
afterAll(async () => {
  for (const each of Object.values(served)) await each.close();
});

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

async function enter(which: string, options: EmulatorOptions = {}): Promise<XrPage> {
  const url = served[which]?.url ?? '';
  const xr = await openXrPage(chromium.browser, url, { device: 'phone', room: 'studio', ...options }, SIZE);
  opened.push(xr);
  await xr.enter();
  return xr;
}

function cameraAt(eye: readonly [number, number, number]): PerspectiveCamera {
  const camera = new PerspectiveCamera((FOV_Y_RAD * 180) / Math.PI, SIZE.width / SIZE.height, 0.1, 100);
  camera.position.set(...eye);
  camera.lookAt(AT);
  camera.updateMatrixWorld();
  return camera;
}

async function look(xr: XrPage, eye: readonly [number, number, number]): Promise<void> {
  const turn = new Quaternion().setFromRotationMatrix(new Matrix4().lookAt(new Vector3(...eye), AT, new Vector3(0, 1, 0)));
  await xr.setPose({ position: eye, quaternion: [turn.x, turn.y, turn.z, turn.w] });
  await xr.step(2);
}

async function screenshot(xr: XrPage): Promise<RgbaImage> {
  return decodeImage(await xr.page.screenshot());
}

const isCard = ([r, g, b]: readonly number[]) => (r ?? 0) > 160 && (g ?? 0) < 110 && (b ?? 0) > 160;
const isText = ([r, g, b]: readonly number[]) => (r ?? 0) > 190 && (g ?? 0) > 190 && (b ?? 0) > 190;

/** The box around the card, and that around its text inside, pixels from the top left. */
function find(picture: RgbaImage) {
  const card = boxOf(picture, isCard, 0, 0, picture.width, picture.height);
  if (!card) throw new Error('There is no card in the picture.');
  const [left, top, right, bottom] = card as [number, number, number, number];
  return { card, text: boxOf(picture, isText, left + 2, top + 2, right - 2, bottom - 2) };
}

function boxOf(picture: RgbaImage, is: (p: readonly number[]) => boolean, x0: number, y0: number, x1: number, y1: number): number[] | null {
  const box = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, -1, -1] as [number, number, number, number];
  for (let y = y0; y < y1; y++) {
    for (let x = x0; x < x1; x++) {
      if (!is(pixelAt(picture, x, y))) continue;
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x + 1);
      box[3] = Math.max(box[3], y + 1);
    }
  }
  return box[2] < 0 ? null : box;
}

function beside(left: RgbaImage, right: RgbaImage): RgbaImage {
  const width = left.width + right.width;
  const data = new Uint8Array(width * left.height * 4);
  for (let y = 0; y < left.height; y++) {
    for (const [picture, at] of [
      [left, 0],
      [right, left.width],
    ] as const) {
      data.set(picture.data.subarray(y * picture.width * 4, (y + 1) * picture.width * 4), (y * width + at) * 4);
    }
  }
  return { width, height: left.height, data };
}

function expectNear(found: readonly number[] | null, expected: readonly number[] | null, withinPx: number): void {
  if (!found || !expected) throw new Error('There is nothing to compare.');
  for (const [i, value] of found.entries()) expect(Math.abs(value - (expected[i] ?? Number.NaN))).toBeLessThanOrEqual(withinPx);
}

describe('a label in an exported page', () => {
  test.each([
    ['fixed to its pose', 'page', 'scene'],
    ['facing the viewer, with a line', 'ledPage', 'ledScene'],
  ])('%s, is the same as an element and as a texture, from six sides', async (name, asElement, asTexture) => {
    const element = await enter(asElement);
    const texture = await enter(asTexture);
    await mkdir(join(OUTPUT_FOLDER, 'labels'), { recursive: true });
    for (const [side, eye] of ANGLES) {
      await look(element, eye);
      await look(texture, eye);
      const [inPage, inScene] = [await screenshot(element), await screenshot(texture)];
      await writeFile(join(OUTPUT_FOLDER, 'labels', `${asElement}-${side}.png`), encodeImage(beside(inPage, inScene)));
      const [ofPage, ofScene] = [find(inPage), find(inScene)];
      expectNear(ofPage.card, ofScene.card, 2);
      expectNear(ofPage.text, ofScene.text, 2);
      if (name !== 'fixed to its pose') continue;
      const corners = await element.page.evaluate(() => {
        const label = document.querySelector('.labels > div')?.shadowRoot?.querySelector<HTMLElement>('p');
        if (!label) return null;
        const { width, height, transform } = label.style;
        const matrix = new DOMMatrix(transform);
        const [w, h] = [Number.parseFloat(width), Number.parseFloat(height)];
        const at = (x: number, y: number) => {
          const point = matrix.transformPoint(new DOMPoint(x, y));
          return [point.x / point.w, point.y / point.w];
        };
        return { w, h, at: [at(0, 0), at(w, 0), at(0, h), at(w, h)] };
      });
      if (!corners) throw new Error('There is no label in the page.');
      const camera = cameraAt(eye);
      for (const [i, found] of corners.at.entries()) {
        const [w, h] = [(corners.w * FONT_M) / FONT_PX, (corners.h * FONT_M) / FONT_PX];
        const corner = new Vector3(i % 2 === 0 ? -w / 2 : w / 2, i < 2 ? h / 2 : -h / 2, 0).add(AT).project(camera);
        expectNear(found as number[], [((corner.x + 1) / 2) * SIZE.width, ((1 - corner.y) / 2) * SIZE.height], 2);
      }
    }
    expect([...element.errors, ...texture.errors]).toEqual([]);
  });

  test('is read by screen readers, and nothing in it is read as HTML', async () => {
    const xr = await enter('page');
    await look(xr, [0, 1.3, 1.6]);
    const { page } = xr;
    const group = page.getByRole('group', { name: 'Labels in the room' });
    const read = (await group.ariaSnapshot()).replaceAll('\\', '');
    expect(read).toContain('<b>Distance</b>');
    expect(read).toContain('1.20 m ± 0.01 m');
    expect(await group.locator('b').count()).toBe(0);
  });

  test('is drawn in the room, and not in the page, by headsets, which show no page', async () => {
    const headset = await enter('page', { device: 'headset' });
    await look(headset, [0, 1.3, 1.6]);
    expect(await headset.page.evaluate(() => document.querySelector('.labels')?.childElementCount)).toBe(0);
    const eyes = await headset.readLayer();
    const card = find(eyes).card ?? [];
    // Both eyes see it, one in each half.
    expect(card[0]).toBeLessThan(eyes.width / 2);
    expect(card[2]).toBeGreaterThan(eyes.width / 2);
    expect(headset.errors).toEqual([]);
  });
});
