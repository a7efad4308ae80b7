import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import type { ToolMain } from '../lib/tool.ts';
import { icnsOf, icoOf, type SizedPng } from './containers.ts';

const SIZES_PX = [16, 32, 48, 128, 256, 512, 1024];

/** Draws the app's icons for each system from `renderer/icon.svg`. */
export const main: ToolMain = async (_args, { root }) => {
  const pictures = await draw(await readFile(join(root, 'renderer', 'icon.svg'), 'utf8'));
  const of = (...sizesPx: number[]) => pictures.filter(({ sizePx }) => sizesPx.includes(sizePx));
  const folder = join(root, 'app', 'electron', 'icons');
  await mkdir(folder, { recursive: true });
  const [large] = of(512);
  if (!large) throw new Error('There is no large picture.');
  await writeFile(join(folder, 'scrim.png'), large.bytes);
  await writeFile(join(folder, 'scrim.ico'), icoOf(of(16, 32, 48, 256)));
  await writeFile(join(folder, 'scrim.icns'), icnsOf(of(128, 256, 512, 1024)));
  console.log(`${folder}: scrim.png, scrim.ico, scrim.icns`);
  return 0;
};

async function draw(svg: string): Promise<SizedPng[]> {
  const found = await findChromium();
  if (!found) throw new Error('No browser was found to draw with; name one in SCRIM_CHROMIUM.');
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage();
    const pictures: SizedPng[] = [];
    for (const sizePx of SIZES_PX) {
      await page.setViewportSize({ width: sizePx, height: sizePx });
      await page.setContent(`<style>body { margin: 0 } svg { display: block; width: 100vw; height: 100vh }</style>${svg}`);
      pictures.push({ sizePx, bytes: await page.screenshot({ omitBackground: true }) });
    }
    return pictures;
  } finally {
    await browser.close();
  }
}
