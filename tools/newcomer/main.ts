import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { installationAt } from '../../app/services/installation.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import type { ToolMain } from '../lib/tool.ts';
import { encodeFilm, type FilmFrame } from './film.ts';
import type { Interaction } from './hands.ts';
import { markInteraction, unmark } from './mark.ts';
import { playNewcomer } from './play-newcomer.ts';

const FILM = 'docs/images/newcomer.webp';
const MODEL = 'examples/first-light/assets/robot.glb';
const SIZE = { width: 1440, height: 900 };
const FRAME_MS = 900;
const LAST_MS = 4000;

/** `npm run newcomer-film`: runs the newcomer's script in the built editor and writes the animated image of the README. */
export const main: ToolMain = async (_args, { root }) => {
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found. Install Chromium, or set SCRIM_CHROMIUM to its path.');
  const base = await mkdtemp(join(tmpdir(), 'scrim-newcomer-'));
  const server = await startServer({ installation: installationAt(root, '0.0.0'), startPath: null, log: console.log });
  const browser = await startBrowser(found);
  try {
    const page = await browser.newPage({ viewport: SIZE, colorScheme: 'dark' });
    await page.goto(server.invite());
    const frames: FilmFrame[] = [];
    let count = 0;
    const onDone = async (done: Interaction) => {
      count++;
      frames.push({ png: await film(page, done, count), ms: FRAME_MS });
    };
    await playNewcomer({ page, model: join(root, MODEL), project: join(base, 'my-robot'), exportTo: join(base, 'page'), onDone });
    frames.push({ png: await page.screenshot(), ms: LAST_MS });
    const bytes = await encodeFilm(frames);
    await writeFile(join(root, FILM), bytes);
    console.log(`${FILM}: ${count} interactions, ${bytes.length} bytes`);
    return 0;
  } finally {
    await browser.close();
    await server.close();
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
