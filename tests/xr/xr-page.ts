import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { HeadPose } from '../../export/emulator/emulator.ts';
// Brings the type of the global that the injected script makes.
import type {} from '../../export/emulator/inject.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { bundleEmulator } from '../../tools/lib/bundle-emulator.ts';
import { collectErrors, drawPageSeldom } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';

const ROOT = resolve(import.meta.dirname, '../..');

/** A served page with an emulated device, whose frames come one by one from the test. */
export interface XrPage {
  readonly page: Page;
  readonly errors: readonly string[];
  /** Presses the page's own button and waits until it draws. */
  enter(): Promise<void>;
  setPose(pose: HeadPose): Promise<void>;
  /** Touches the screen at the first point, moves the finger along the others and lifts it. Points: 0 to 1 from the left and the top. */
  touch(...points: readonly (readonly [x: number, y: number])[]): Promise<void>;
  step(count?: number): Promise<void>;
  /** What the page drew in the last frame, premultiplied. */
  readLayer(): Promise<RgbaImage>;
  /** What the visitor saw in the last frame. */
  readComposite(): Promise<RgbaImage>;
  /** What the device's cameras saw in the last frame. */
  readRoom(): Promise<RgbaImage>;
  /** Distance to the room along a ray, meters, or null. */
  measure(originWorld: readonly number[], directionWorld: readonly number[]): Promise<number | null>;
  close(): Promise<void>;
}

/** A capture of `@iwer/sem`, by name. */
export async function readCapture(name: string): Promise<{ readonly capture: unknown }> {
  return { capture: JSON.parse(await readFile(resolve(ROOT, `node_modules/@iwer/sem/captures/${name}.json`), 'utf8')) };
}

let injected: Promise<string> | undefined;

/** Opens an exported page as a visitor with the emulated device would; the page itself knows nothing of it. */
export async function openXrPage(
  browser: Browser,
  url: string,
  options: EmulatorOptions,
  viewport = { width: 480, height: 360 },
  /** Runs in the page after the emulator is there. */
  script = '',
  /** Between frames of the page outside sessions, if these are expensive and of no interest. */
  idleFrameMs?: number,
): Promise<XrPage> {
  injected ??= bundleEmulator(ROOT);
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  const errors = collectErrors(page);
  await drawPageSeldom(page, idleFrameMs);
  await page.addInitScript({ content: await injected });
  await page.addInitScript((given: unknown) => void scrimEmulator?.install(given as EmulatorOptions), { clock: 'manual', ...options });
  if (script !== '') await page.addInitScript({ content: script });
  await page.goto(url);
  return {
    page,
    errors,
    enter: async () => {
      await page.getByRole('button', { name: 'Enter AR' }).click();
      await page.evaluate(() => scrimEmulator?.current?.frameRequested());
      // Depth and images of a device come with its first frames.
      await page.evaluate(() => scrimEmulator?.current?.stepFrame(3));
    },
    setPose: (pose) => page.evaluate((p) => scrimEmulator?.current?.setPose(p), pose),
    step: (count = 1) => page.evaluate((n) => scrimEmulator?.current?.stepFrame(n), count),
    touch: async (...points) => {
      for (const [i, point] of points.entries()) {
        await page.evaluate(([first, [x, y]]) => scrimEmulator?.current?.[first ? 'press' : 'move'](x, y), [i === 0, point] as const);
        await page.evaluate(() => scrimEmulator?.current?.stepFrame(2));
      }
      await page.evaluate(() => scrimEmulator?.current?.release());
      await page.evaluate(() => scrimEmulator?.current?.stepFrame(4));
    },
    readLayer: () => readPicture(page, 'readLayer'),
    readComposite: () => readPicture(page, 'readComposite'),
    readRoom: () => readPicture(page, 'readRoom'),
    measure: (origin, direction) => page.evaluate(([o, d]) => scrimEmulator?.current?.measure(o, d) ?? null, [origin, direction] as const),
    close: () => context.close(),
  };
}

/** Bytes as base64: as a list of numbers an image takes ten times as long. */
async function readPicture(page: Page, what: 'readLayer' | 'readComposite' | 'readRoom'): Promise<RgbaImage> {
  const { width, height, base64 } = await page.evaluate((method) => {
    const pixels = scrimEmulator?.current?.[method]();
    if (!pixels) throw new Error('There is no emulator.');
    let text = '';
    for (let i = 0; i < pixels.rgba.length; i += 8192) text += String.fromCharCode(...pixels.rgba.subarray(i, i + 8192));
    return { width: pixels.widthPx, height: pixels.heightPx, base64: btoa(text) };
  }, what);
  return { width, height, data: new Uint8Array(Buffer.from(base64, 'base64')) };
}
