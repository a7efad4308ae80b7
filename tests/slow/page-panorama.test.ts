import { mkdir, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Locator } from 'playwright-core';
import { projectEye } from '../../export/emulator/session/projection.ts';
import { linearFromSrgb, srgbFromLinear } from '../../nodes/kit/color-math.ts';
import { captureTargets, type Direction } from '../../nodes/kit/panorama/capture-targets.ts';
import { findByPaper } from '../../nodes/kit/panorama/paper-method.ts';
import { type PanoramaPixels, runWhole } from '../../nodes/kit/panorama/pixels.ts';
import { findBySolidAngle } from '../../nodes/kit/panorama/solid-angle-method.ts';
import { toEquirectangular } from '../../nodes/kit/panorama/to-equirectangular.ts';
import { useBrowser } from '../support/browser.ts';
import { decodeImage, encodeImage, pixelAt, type RgbaImage } from '../support/image.ts';
import { angleDeg, barOf, poseFrom, storedPanorama, takePhotos, untilReady } from '../support/panorama-page.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

/** An exported page takes the panorama of the emulated studio. */

const EXAMPLE = resolve(import.meta.dirname, '../../nodes/source/panorama-capture/example');
const WIDTH_PX = 1024;
/** From here, the glow of the window on the ceiling is narrow enough for a lamp. */
const EYE = [2, 1.6, 0.5] as const;
/** Of the emulated phone. */
const FOV_Y_RAD = 1.05;
/** A photo takes 0.4 s after the camera has stopped. */
const FRAMES_PER_SECOND = 4;
const VIEW = { width: 480, height: 360 };
const FACE_PX = 512;
/** Outside the session, where no test looks at a picture. */
const IDLE_FRAME_MS = 1000;

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProject(EXAMPLE);
});
afterAll(() => served.close());

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

async function open(more: Parameters<typeof openXrPage>[2] = {}): Promise<XrPage> {
  const options = { device: 'phone', room: 'studio', framesPerSecond: FRAMES_PER_SECOND, ...more } as const;
  const xr = await openXrPage(chromium.browser, served.url, options, VIEW, '', IDLE_FRAME_MS);
  opened.push(xr);
  return xr;
}

const TARGETS = captureTargets(projectEye('none', FOV_Y_RAD, VIEW.width / VIEW.height, 0.1, 100));

/** How tracking differs between two sessions. */
const TURN_RAD = 0.9;

/** Turns to where photos were taken, until the page shows something. */
async function lookAround(xr: XrPage, until: Locator): Promise<void> {
  for (let i = 0; !(await until.isVisible()); i++) {
    const angle = 0.35 * i + TURN_RAD;
    await xr.setPose(poseFrom(EYE, [Math.sin(angle), 0, -Math.cos(angle)]));
    await xr.step(3);
  }
}

const CUBE: readonly Direction[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, -1],
  [0, 0, 1],
];

/** Of a byte. */
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => linearFromSrgb(byte / 255));

/** The room by six cameras of 90°, averaged to the size of the panorama in linear light. */
async function truePanorama(xr: XrPage): Promise<PanoramaPixels & { readonly data: Uint8ClampedArray }> {
  await xr.page.evaluate((side) => {
    scrimEmulator?.current?.setFovY(Math.PI / 2);
    scrimEmulator?.current?.setSize([side, side]);
  }, FACE_PX);
  const data = new Uint8Array(6 * FACE_PX * FACE_PX * 4);
  for (const [i, direction] of CUBE.entries()) {
    await xr.setPose(poseFrom(EYE, direction));
    await xr.step(2);
    const face = await xr.readRoom();
    for (let y = 0; y < FACE_PX; y++) {
      data.set(face.data.subarray(y * FACE_PX * 4, (y + 1) * FACE_PX * 4), (y * 6 + i) * FACE_PX * 4);
    }
  }
  const large = toEquirectangular({ widthPx: 6 * FACE_PX, heightPx: FACE_PX, channels: 4, data }, 'strip');
  const step = large.widthPx / WIDTH_PX;
  const small = new Uint8ClampedArray((WIDTH_PX * WIDTH_PX * 4) / 2);
  for (let i = 0; i < small.length; i++) {
    const [x, y, c] = [(i >> 2) % WIDTH_PX, Math.floor((i >> 2) / WIDTH_PX), i & 3];
    let sum = 0;
    for (let k = 0; k < step * step; k++) {
      const at = ((y * step + Math.floor(k / step)) * large.widthPx + x * step + (k % step)) * 4 + c;
      sum += LINEAR[large.data[at] ?? 0] ?? 0;
    }
    small[i] = Math.round(255 * srgbFromLinear(sum / (step * step)));
  }
  return { widthPx: WIDTH_PX, heightPx: WIDTH_PX / 2, channels: 4, data: small };
}

/** In decibels, over the pixels that were photographed. */
function decibels(taken: PanoramaPixels, truth: PanoramaPixels): number {
  let errors = 0;
  let count = 0;
  for (let i = 0; i < taken.data.length; i += 4) {
    if (taken.data[i + 3] !== 255) continue;
    for (let c = 0; c < 3; c++) errors += ((taken.data[i + c] ?? 0) - (truth.data[i + c] ?? 0)) ** 2;
    count += 3;
  }
  return 10 * Math.log10((255 * 255 * count) / errors);
}

function pictureOf({ data, widthPx, heightPx }: PanoramaPixels): RgbaImage {
  const opaque = Uint8Array.from(data);
  for (let i = 3; i < opaque.length; i += 4) opaque[i] = 255;
  return { width: widthPx, height: heightPx, data: opaque };
}

/** To look at: `SCRIM_PICTURES` is a folder. */
async function show(name: string, picture: () => RgbaImage | Promise<RgbaImage>): Promise<void> {
  const { SCRIM_PICTURES: folder } = process.env;
  if (folder === undefined) return;
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, name), encodeImage(await picture()));
}

/** The strongest lamp by each method: the others are weaker parts of the same window. */
function lampsOf(pixels: PanoramaPixels) {
  const bySolidAngle = runWhole(findBySolidAngle(pixels, { lamps: 1, clippedShare: 0.5 }));
  const byPaper = runWhole(findByPaper(pixels, { lamps: 1, iterations: 1, intensities: 'area' }));
  return [...bySolidAngle.lamps, ...byPaper.lamps];
}

describe('a page with a panorama of the room', () => {
  test('is preceded by 34 targets, which become the panorama of the room: 30 dB, lamps within 2°', async () => {
    const xr = await open();
    await xr.setPose(poseFrom(EYE, [0.3, 0.2, -1].map((value) => value / Math.hypot(0.3, 0.2, 1)) as [number, number, number]));
    await xr.enter();
    await barOf(xr).getByText('0 of 34 photos.').waitFor();
    await takePhotos(xr, EYE, TARGETS.slice(0, 9));
    await barOf(xr).getByText('9 of 34 photos.').waitFor();
    await xr.setPose(poseFrom(EYE, [Math.sin(0.3), 0, -Math.cos(0.3)]));
    await xr.step(1);
    const layer = await xr.readLayer();
    await show('targets.png', () => xr.readComposite());
    // Straight ahead is a green disc; the program is not drawn.
    const [red, green, blue, alpha] = pixelAt(layer, Math.round(VIEW.width * 0.28), VIEW.height / 2);
    expect([green, alpha].every((value) => (value ?? 0) > 80)).toBe(true);
    expect((green ?? 0) - Math.max(red ?? 0, blue ?? 0)).toBeGreaterThan(40);
    await show('bar.png', async () => decodeImage(await xr.page.screenshot()));
    await takePhotos(xr, EYE, TARGETS.slice(9));
    await untilReady(xr);
    const taken = await storedPanorama(xr);
    await xr.setPose(poseFrom(EYE, [0, 0, -1]));
    await xr.step(process.env.SCRIM_PICTURES === undefined ? 2 : 20);
    await show('lit.png', () => xr.readComposite());
    const truth = await truePanorama(xr);
    await show('taken.png', () => pictureOf(taken));
    await show('true.png', () => pictureOf(truth));
    const db = decibels(taken, truth);
    const [found, expected] = [lampsOf(taken), lampsOf(truth)];
    expect([found.length, expected.length]).toEqual([2, 2]);
    const anglesDeg = expected.map(({ towards }, i) => angleDeg(towards, found[i]?.towards ?? [0, 0, 0]));
    console.info(`Stitched against true: ${db.toFixed(1)} dB, lamps within ${Math.max(...anglesDeg).toFixed(2)}°.`);
    expect(db).toBeGreaterThan(30);
    expect(Math.max(...anglesDeg)).toBeLessThan(2);
    expect(xr.errors).toEqual([]);
  });

  test('keeps the photos of a visitor who gives up midway, and finds the panorama again at the next visit', async () => {
    const xr = await open({ sizePx: [200, 150] });
    await xr.setPose(poseFrom(EYE, [0, 0, -1]));
    await xr.enter();
    await takePhotos(xr, EYE, TARGETS.slice(0, 10));
    await barOf(xr).getByText('10 of 34 photos.').waitFor();
    await xr.page.getByRole('button', { name: 'Leave AR' }).click();
    await xr.page.getByRole('button', { name: 'Enter AR' }).waitFor();
    // Tracking begins with another heading.
    await xr.page.evaluate((yaw) => scrimEmulator?.current?.drift([0, 0, 0], yaw), TURN_RAD);
    await xr.enter();
    await barOf(xr).getByText('There are 10 photos of your last try.').waitFor();
    await xr.page.getByRole('button', { name: 'Continue' }).click();
    await lookAround(xr, barOf(xr).getByText('of 34 photos.'));
    await xr.step(1);
    await barOf(xr).getByText('10 of 34 photos.').waitFor();
    await xr.page.getByRole('button', { name: 'Use these photos' }).click();
    await untilReady(xr);
    await xr.page.getByText(/\d+ % around you were not photographed/).waitFor();

    await xr.page.reload();
    await xr.page.evaluate((yaw) => scrimEmulator?.current?.drift([0, 0, 0], yaw), TURN_RAD);
    await xr.setPose(poseFrom(EYE, [0, 0, -1]));
    await xr.enter();
    await barOf(xr).getByText('Look around slowly').waitFor();
    await lookAround(xr, barOf(xr).getByText('The light is that of your room'));

    await xr.page.getByRole('button', { name: 'Take the panorama again' }).click();
    await xr.step(1);
    await barOf(xr).getByText('0 of 34 photos.').waitFor();
    await xr.page.getByRole('button', { name: 'Skip' }).click();
    await barOf(xr).waitFor({ state: 'hidden' });
    expect(xr.errors).toEqual([]);
  });

  test.each(['glasses', 'phone'] as const)('says that a device without camera images uses the file: %s', async (device) => {
    const xr = await open({ device, refuse: ['camera-access'], room: null });
    await xr.enter();
    await xr.page
      .getByText('This device gives pages no camera image, so the light is that of a panorama file.')
      .waitFor({ state: 'attached' });
    expect(await barOf(xr).isVisible()).toBe(false);
    expect(xr.errors).toEqual([]);
  });

  test('takes a picture of the visitor instead, and says what is wrong with others', async () => {
    const xr = await open({ refuse: ['camera-access'], room: null });
    await xr.page.getByText('Panorama of your room').click();
    const card = xr.page.locator('details', { hasText: 'Panorama of your room' });
    const choose = (name: string, buffer: Uint8Array) =>
      card.getByLabel('Panorama file').setInputFiles({ name, mimeType: 'image/png', buffer: Buffer.from(buffer) });
    const plain = (width: number, height: number) => encodeImage({ width, height, data: new Uint8Array(width * height * 4).fill(200) });
    await choose('wide.png', plain(160, 90));
    await card.getByText('It has 160 × 90 pixels').waitFor();
    await choose('text.png', Buffer.from('no picture'));
    await card.getByText('The file is no picture').waitFor();
    await choose('cut.png', plain(64, 32).slice(0, 60));
    await card.getByText('The file is no picture').waitFor();
    await choose('room.png', plain(64, 32));
    await card.getByText('The picture is used.').waitFor();
    expect((await storedPanorama(xr)).widthPx).toBe(WIDTH_PX);
    await card.getByRole('button', { name: 'Delete' }).click();
    await card.getByText('You can also choose a picture').waitFor();
    expect(xr.errors).toEqual([]);
  });
});
