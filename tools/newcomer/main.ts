import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { installationAt } from '../../app/services/installation.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import { type AnimationFrame, encodeAnimation } from '../lib/animated-webp.ts';
import type { ToolMain } from '../lib/tool.ts';
import type { NewcomerOptions } from './editor-steps.ts';
import type { Interaction } from './hands.ts';
import { markInteraction, unmark } from './mark.ts';
import { playNewcomer } from './play-newcomer.ts';
import { playPlacing, tryPlacing } from './play-placing.ts';

const WIDTH_PX = 900;

/** WebP quality at which texts of nodes stay readable. 25 frames take about 500 kB. */
const QUALITY = 60;

const FILMS = [
  { file: 'docs/images/newcomer.webp', play: playNewcomer },
  {
    file: 'docs/images/placing.webp',
    play: async (options: NewcomerOptions) => {
      await playPlacing(options);
      await tryPlacing(options.page, options.onDone ?? (async () => {}));
    },
  },
] as const;
const MODEL = 'examples/first-light/assets/robot.glb';
const SIZE = { width: 1440, height: 900 };
const FRAME_MS = 900;
const LAST_MS = 4000;

/**
 * `npm run newcomer-film`: runs the newcomer's scripts in the built editor and writes the animated images of the documentation;
 * `-- placing` only the one whose path contains that.
 */
export const main: ToolMain = async ([wanted = ''], { root }) => {
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found. Install Chromium, or set SCRIM_CHROMIUM to its path.');
  const base = await mkdtemp(join(tmpdir(), 'scrim-newcomer-'));
  const browser = await startBrowser(found);
  try {
    for (const [i, { file, play }] of FILMS.filter((film) => film.file.includes(wanted)).entries()) {
      const server = await startServer({ installation: installationAt(root, '0.0.0'), startPath: null, log: console.log });
      const page = await browser.newPage({ viewport: SIZE, colorScheme: 'dark', reducedMotion: 'reduce' });
      await page.goto(server.invite());
      const frames: AnimationFrame[] = [];
      const onDone = async (done: Interaction) => {
        frames.push({ png: await film(page, done, frames.length + 1), ms: FRAME_MS });
      };
      const folders = { project: join(base, `my-robot-${i}`), exportTo: join(base, `page-${i}`) };
      await play({ page, model: join(root, MODEL), ...folders, onDone });
      frames.push({ png: await page.screenshot(), ms: LAST_MS });
      const bytes = await encodeAnimation(frames, WIDTH_PX, QUALITY);
      await writeFile(join(root, file), bytes);
      console.log(`${file}: ${frames.length - 1} interactions, ${bytes.length} bytes`);
      await page.close();
      await server.close();
    }
    return 0;
  } finally {
    await browser.close();
    await rm(base, { recursive: true, force: true });
  }
};

/** A screenshot after an interaction, with a mark at its place and its caption. */
async function film(page: Page, done: Interaction, count: number): Promise<Uint8Array> {
  await page.waitForFunction(() => !/Compiling/.test(document.querySelector('.status-bar')?.textContent ?? ''));
  await markInteraction(page, done, count);
  const png = await page.screenshot();
  await unmark(page);
  return png;
}
