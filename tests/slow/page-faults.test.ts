import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import type { Emulator } from '../../export/emulator/emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProjectText } from '../support/project-page.ts';
import { roomBox } from '../xr/room-box.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

// What fails on devices, one after the other, beside a page that runs on: each is said, and unsaid when it is over.

const FLOOR = { label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [8, 0.1, 8] } as const;
/** Before the left half of the box, for eyes that look along −z. */
const BOARD = { label: 'other', centerWorld: [-1, 0.6, 1.2], sizeM: [2, 1.2, 0.1] } as const;
/** Few, so that seconds of waiting are few frames. */
const FRAMES_PER_SECOND = 5;
const ROOM: EmulatorOptions = {
  room: { boxes: [FLOOR, BOARD] },
  framesPerSecond: FRAMES_PER_SECOND,
  display: false,
  // The filters of depth take most of a frame.
  depth: { sizePx: [80, 60] },
};
const VIEWPORT = { width: 240, height: 180 };
const EYE = { position: [0, 0.9, 3] } as const;

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProjectText(roomBox(0, 0), {});
});
afterAll(() => served?.close());

let xr: XrPage | undefined;
afterEach(async () => {
  const errors = xr?.errors ?? [];
  await xr?.close();
  xr = undefined;
  expect(errors).toEqual([]);
});

async function open(options: EmulatorOptions): Promise<XrPage> {
  xr = await openXrPage(chromium.browser, served.url, { ...ROOM, ...options }, VIEWPORT);
  return xr;
}

async function enter(options: EmulatorOptions): Promise<XrPage> {
  const page = await open(options);
  await page.enter();
  await page.setPose(EYE);
  await page.step(2);
  return page;
}

/** Seconds of the device's time. */
const wait = (page: XrPage, seconds: number) => page.step(Math.ceil(seconds * FRAMES_PER_SECOND));

type State = Parameters<Emulator['setDepth']>[0] | Parameters<Emulator['setLight']>[0];
const set = (page: XrPage, what: 'setDepth' | 'setLight', state: State) =>
  page.page.evaluate(([name, value]) => (scrimEmulator?.current?.[name] as ((state: unknown) => void) | undefined)?.(value), [
    what,
    state,
  ] as const);

/** How much of the left and of the right half of a view there is something on. */
function halves({ width, height, data }: RgbaImage, views: number): readonly [left: number, right: number] {
  const counts: [number, number] = [0, 0];
  const middle = width / views / 2;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < 2 * middle; x++) if ((data[(y * width + x) * 4 + 3] ?? 0) > 200) counts[x < middle ? 0 : 1]++;
  return counts;
}

/** Mean of what is opaque. */
function brightness({ data }: RgbaImage): number {
  let sum = 0;
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] !== 255) continue;
    sum += data[i] ?? 0;
    count++;
  }
  return sum / count;
}

const DEPTH_SILENT = 'measures no depth';
const LIGHT_SILENT = 'does not measure the light';

/** Notices are on the page itself, which a headset's visitor sees before and after. */
const notice = (page: XrPage, text: string) => page.page.getByText(text);

describe.each([
  ['phone', 1, 0.4],
  // Its eyes see further outwards, so that the left one has less of the box on the left.
  ['headset', 2, 0.1],
] as const)('on a %s', (device, views, leastShare) => {
  const options: EmulatorOptions = { device, extra: ['light-estimation'] };

  test('depth stops: it is said, the picture goes on with nothing hidden, and all is well when it is back', async () => {
    const page = await enter(options);
    const before = halves(await page.readLayer(), views);
    expect(before[1]).toBeGreaterThan(100);
    expect(before[0]).toBeLessThan((before[1] * leastShare) / 4);
    await set(page, 'setDepth', 'stopped');
    await wait(page, 1);
    expect(await notice(page, DEPTH_SILENT).count()).toBe(0);
    await wait(page, 1.5);
    await notice(page, DEPTH_SILENT).waitFor({ state: 'attached' });
    const during = halves(await page.readLayer(), views);
    expect(during[0]).toBeGreaterThan(during[1] * leastShare);
    await set(page, 'setDepth', 'working');
    await page.step(2);
    await notice(page, DEPTH_SILENT).waitFor({ state: 'detached' });
    expect(halves(await page.readLayer(), views)).toEqual(before);
  });

  test('light is no longer measured: it is said, the picture goes on by a guess, and follows when it is back', async () => {
    const page = await enter(options);
    // A dim room, dimmer than any guess.
    const dim = { sphericalHarmonics: Array.from({ length: 27 }, (_, i) => (i < 3 ? 0.05 : 0)), intensity: [0.05, 0.05, 0.05] } as const;
    await set(page, 'setLight', dim);
    await wait(page, 0.5);
    const before = brightness(await page.readLayer());
    await set(page, 'setLight', 'stopped');
    await wait(page, 1);
    expect(Math.abs(brightness(await page.readLayer()) - before)).toBeLessThan(2);
    expect(await notice(page, LIGHT_SILENT).count()).toBe(0);
    await wait(page, 3);
    await notice(page, LIGHT_SILENT).waitFor({ state: 'attached' });
    expect(brightness(await page.readLayer())).toBeGreaterThan(before + 30);
    await set(page, 'setLight', dim);
    await wait(page, 0.5);
    await notice(page, LIGHT_SILENT).waitFor({ state: 'detached' });
    expect(Math.abs(brightness(await page.readLayer()) - before)).toBeLessThan(2);
  });

  test('tracking is lost and found, and what was said of sensors meanwhile stays true', async () => {
    const page = await enter(options);
    const before = halves(await page.readLayer(), views);
    await page.page.evaluate(() => scrimEmulator?.current?.setTracked(false));
    await wait(page, 5);
    await notice(page, 'Looking for the room').waitFor({ state: 'attached' });
    // A device without tracking need not deliver depth.
    expect(await notice(page, DEPTH_SILENT).count()).toBe(0);
    await page.page.evaluate(() => scrimEmulator?.current?.setTracked(true));
    await page.step(3);
    await notice(page, 'Looking for the room').waitFor({ state: 'detached' });
    expect(await notice(page, DEPTH_SILENT).count()).toBe(0);
    expect(halves(await page.readLayer(), views)).toEqual(before);
  });

  test('a feature is refused: it is said what the page does without, and it runs', async () => {
    const page = await enter({ ...options, refuse: ['depth-sensing', 'light-estimation'], extra: [] });
    await notice(page, 'Not available here: the depth of the room.').waitFor({ state: 'attached' });
    await notice(page, 'the light in the room.').waitFor({ state: 'attached' });
    const [left, right] = halves(await page.readLayer(), views);
    expect(right).toBeGreaterThan(100);
    expect(left).toBeGreaterThan(right * leastShare);
    await wait(page, 8);
    // What was never granted is not missed.
    expect(await notice(page, DEPTH_SILENT).count()).toBe(0);
  });

  test('the system ends the session while depth is silent: one notice, a view to look around in, and a second try', async () => {
    const page = await enter(options);
    await set(page, 'setDepth', 'stopped');
    await wait(page, 3);
    await notice(page, DEPTH_SILENT).waitFor({ state: 'attached' });
    await page.page.evaluate(() => scrimEmulator?.current?.endSession());
    await notice(page, 'AR has ended').waitFor();
    expect(await notice(page, DEPTH_SILENT).count()).toBe(0);
    await set(page, 'setDepth', 'working');
    await page.enter();
    expect(await notice(page, 'AR has ended').count()).toBe(0);
    await page.setPose(EYE);
    await page.step(2);
    expect(halves(await page.readLayer(), views)[1]).toBeGreaterThan(100);
  });
});

test('the session is refused altogether: it is said, and the page can still be looked around in', async () => {
  const page = await open({ requireGesture: true });
  await page.page.evaluate(() => {
    const { xr: system } = navigator;
    if (system) system.requestSession = () => Promise.reject(new DOMException('The user said no.', 'NotAllowedError'));
  });
  await page.page.getByRole('button', { name: 'Enter AR' }).click();
  await notice(page, 'AR was not allowed').waitFor();
  await page.page.getByRole('button', { name: 'Enter AR' }).waitFor();
});
