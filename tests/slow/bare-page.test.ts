import { copyFile, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { BARE_HTML, bundleBarePage } from '../../tools/bench/bare-page.ts';
import { bundleEmulator } from '../../tools/lib/bundle-emulator.ts';
import { collectErrors, drawPageSeldom, useBrowser } from '../support/browser.ts';
import { decodeImage } from '../support/image.ts';
import { type StaticServer, serveStatic } from '../support/serve.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const SIZE = { width: 240, height: 180 };

const chromium = useBrowser();
let folder: string;
let host: StaticServer;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'scrim-bare-'));
  await writeFile(join(folder, 'index.html'), BARE_HTML.replace(/<img.*>/, '<i class="poster"></i>'));
  await writeFile(join(folder, 'bare.js'), await bundleBarePage(ROOT));
  await copyFile(join(ROOT, 'examples/first-light/assets/robot.glb'), join(folder, 'robot.glb'));
  host = await serveStatic({ '/': `${folder}/` });
});

afterAll(async () => {
  await host?.close();
  if (folder) await rm(folder, { recursive: true, force: true });
});

/** The global of the emulated device, as far as this file uses it. */
interface WithEmulator {
  readonly scrimEmulator: {
    install(options: object): void;
    readonly current: {
      setPose(pose: object): void;
      frameRequested(): Promise<void>;
      stepFrame(): Promise<void>;
      readComposite(): { readonly rgba: Uint8Array };
    };
  };
}

/** Number of pixels in the red of a robot. */
function countRed(rgba: Uint8Array | Uint8ClampedArray): number {
  let count = 0;
  for (let i = 0; i < rgba.length; i += 4) {
    const [red = 0, green = 0, blue = 0] = rgba.subarray(i, i + 3);
    if (red > 70 && red > 2.5 * green && red > 2.5 * blue) count++;
  }
  return count;
}

test('the bare page of the benches draws the robots, and hides in AR what is behind the room', async () => {
  const page = await chromium.browser.newPage({ viewport: SIZE });
  const errors = collectErrors(page);
  await drawPageSeldom(page);
  await page.addInitScript({ content: await bundleEmulator(ROOT) });
  await page.addInitScript((options) => (globalThis as unknown as WithEmulator).scrimEmulator.install(options), {
    device: 'phone',
    room: 'studio',
    clock: 'manual',
    sizePx: [SIZE.width, SIZE.height],
    depth: { usages: ['cpu-optimized'] },
  });
  await page.goto(host.origin);
  await page.locator('.poster').waitFor({ state: 'detached' });
  expect(countRed(decodeImage(await page.screenshot()).data)).toBeGreaterThan(200);
  await page.getByText('START AR').click();
  const redAt = (isWithDepth: boolean): Promise<number> =>
    page
      .evaluate(async (hasDepth) => {
        const { current } = (globalThis as unknown as WithEmulator).scrimEmulator;
        const shared = globalThis as unknown as { ownDepth?: unknown };
        shared.ownDepth ??= XRFrame.prototype.getDepthInformation;
        Object.assign(XRFrame.prototype, { getDepthInformation: hasDepth ? shared.ownDepth : () => undefined });
        current.setPose({ position: [0, 0.9, 1.4] });
        await current.frameRequested();
        for (let i = 0; i < 2; i++) await current.stepFrame();
        return [...current.readComposite().rgba];
      }, isWithDepth)
      .then((rgba) => countRed(Uint8Array.from(rgba)));
  const whole = await redAt(false);
  const seen = await redAt(true);
  expect(whole).toBeGreaterThan(200);
  expect(seen).toBeLessThan(0.8 * whole);
  expect(seen).toBeGreaterThan(0.1 * whole);
  expect(errors).toEqual([]);
  await page.close();
}, 60_000);
