import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { findChromium } from '../../../app/services/chromium.ts';
import { startBrowser } from '../../../app/services/start-browser.ts';
// Brings the type of the global that the injected script makes.
import type {} from '../../../export/emulator/inject.ts';
import { type AnimationFrame, encodeAnimation } from '../../lib/animated-webp.ts';
import { exportExample, openEmulatedPage } from '../../lib/emulated-page.ts';
import type { ToolMain } from '../../lib/tool.ts';
import { FILMS, type Film } from './films.ts';

const SIZE = { width: 640, height: 400 };
const WIDTH_PX = 560;
/** Each film has 100 to 160 kB. */
const QUALITY = 55;
/** Frames of the device, and images of the film, per second. */
const HZ = 12;
/** Frames in which a finger touches the screen, and in which its mark is seen. */
const TOUCH_FRAMES = 2;
const MARK_FRAMES = 6;
const MARK_ID = 'touch-mark';
/** Frames before the film, in which the room is measured. */
const FIRST_FRAMES = 16;

/**
 * `npm run example-films` plays the physics examples on an emulated phone, with touches, and writes the animated images of the
 * documentation; `-- marble` only the one whose name contains that. Without workers each frame has its own step of the simulation, so
 * that a film is the same each time.
 */
export const main: ToolMain = async ([wanted = ''], { root }) => {
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found. Install Chromium, or set SCRIM_CHROMIUM to its path.');
  const browser = await startBrowser(found);
  try {
    for (const film of FILMS.filter(({ example }) => example.includes(wanted))) {
      const images = await shoot(browser, root, film);
      const bytes = await encodeAnimation(images, WIDTH_PX, QUALITY);
      const file = `docs/images/${film.example}.webp`;
      await writeFile(join(root, file), bytes);
      console.log(`${file}: ${images.length} images, ${bytes.length} bytes`);
    }
    return 0;
  } finally {
    await browser.close();
  }
};

async function shoot(browser: Browser, root: string, { example, seconds, pose, touches }: Film): Promise<readonly AnimationFrame[]> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-film-'));
  try {
    const folder = await exportExample(root, example, base);
    const device = { device: 'phone', room: 'studio', framesPerSecond: HZ, antialias: true, display: true };
    const page = await openEmulatedPage(browser, { root, folder, sizePx: SIZE, device, script: withoutWorkers });
    const play = async (frame: number) => {
      const touch = touches.find(({ atS }) => Math.round(atS * HZ) === frame);
      const lifted = touches.some(({ atS }) => Math.round(atS * HZ) + TOUCH_FRAMES === frame);
      const unmarked = touches.some(({ atS }) => Math.round(atS * HZ) + MARK_FRAMES === frame);
      if (unmarked) await hideTouch(page);
      if (touch) await showTouch(page, touch.x * SIZE.width, touch.y * SIZE.height);
      await page.evaluate(
        async ([point, isLifted]) => {
          const device = scrimEmulator?.current;
          if (point) device?.press(...point);
          if (isLifted) device?.release();
          await device?.stepFrame();
        },
        [touch ? ([touch.x, touch.y] as const) : null, lifted] as const,
      );
    };
    await page.evaluate((held) => scrimEmulator?.current?.setPose(held), pose);
    for (let frame = -FIRST_FRAMES; frame < 0; frame++) await play(frame);
    return await filmFrames(page, Math.round(seconds * HZ), play);
  } finally {
    await rm(base, { recursive: true, force: true });
  }
}

async function filmFrames(page: Page, count: number, play: (frame: number) => Promise<void>): Promise<readonly AnimationFrame[]> {
  const images: AnimationFrame[] = [];
  for (let frame = 0; frame < count; frame++) {
    await play(frame);
    images.push({ png: await page.screenshot(), ms: Math.round(1000 / HZ) });
  }
  await page.close();
  return images;
}

/** Runs in the page. */
function withoutWorkers(): void {
  Reflect.deleteProperty(globalThis, 'Worker');
}

/** Draws a ring over the page where a finger touches it. */
async function showTouch(page: Page, x: number, y: number): Promise<void> {
  await page.evaluate(
    ([id, left, top]) => {
      document.getElementById(id)?.remove();
      const mark = document.createElement('div');
      mark.id = id;
      mark.popover = 'manual';
      mark.style.cssText = `position:fixed;inset:auto;left:${left - 18}px;top:${top - 18}px;width:36px;height:36px;margin:0;padding:0;box-sizing:border-box;border-radius:50%;border:3px solid #fff;background:rgb(255 255 255 / 30%);pointer-events:none`;
      document.body.append(mark);
      // A popover is above the overlay of the page.
      mark.showPopover();
    },
    [MARK_ID, x, y] as const,
  );
}

async function hideTouch(page: Page): Promise<void> {
  await page.evaluate((id) => document.getElementById(id)?.remove(), MARK_ID);
}
