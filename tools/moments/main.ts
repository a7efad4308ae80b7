import { cp, mkdir, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import type { Browser } from 'playwright-core';
import { startServer } from '../../app/server/start-server.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { installationAt } from '../../app/services/installation.ts';
import { createPageServers } from '../../app/services/page-servers.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import type { ToolMain } from '../lib/tool.ts';
import { EXPORTED, isPainted, isSettled, MOMENTS, type Moment } from './moments.ts';

const SIZES = ['1440x900', '1024x768', '2560x1440'] as const;
const THEMES = ['dark', 'light'] as const;
const PHONE = { width: 390, height: 844 };

interface Screen {
  readonly size: string;
  readonly theme: (typeof THEMES)[number];
}

/**
 * `npm run moments -- OUT [--size 1440x900] [--theme dark] [--moment NAME]` takes screenshots of the built editor in the moments of a first
 * hour, from the start screen to the exported page on a phone, to the files `OUT/SIZE-THEME/NAME.png`. Compare them with those of an earlier
 * version.
 */
export const main: ToolMain = async (args, { root }) => {
  const [out] = args;
  if (out === undefined || out.startsWith('--')) {
    console.error('Usage: npm run moments -- OUT [--size 1440x900] [--theme dark] [--moment NAME]');
    return 2;
  }
  const only = (flag: string) => (args.includes(flag) ? args[args.indexOf(flag) + 1] : undefined);
  const wanted = <T extends string>(flag: string, all: readonly T[]) => all.filter((one) => (only(flag) ?? one) === one);
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found. Install Chromium, or set SCRIM_CHROMIUM to its path.');
  const browser = await startBrowser(found);
  try {
    for (const size of wanted('--size', SIZES)) {
      for (const theme of wanted('--theme', THEMES)) {
        const folder = join(resolve(out), `${size}-${theme}`);
        await mkdir(folder, { recursive: true });
        const base = await mkdtemp(join(tmpdir(), 'scrim-moments-'));
        for (const moment of MOMENTS.filter(({ name }) => (only('--moment') ?? name) === name)) {
          await show(browser, root, base, { size, theme }, moment, folder);
          console.log(`${folder}/${moment.name}.png`);
        }
        await rm(base, { recursive: true, force: true });
      }
    }
    return 0;
  } finally {
    await browser.close();
  }
};

/** Opens a copy of the moment's project as for the first time, goes to the moment, and takes the screenshot. */
async function show(browser: Browser, root: string, base: string, screen: Screen, moment: Moment, folder: string): Promise<void> {
  const project = moment.project === null ? null : join(base, moment.name);
  if (moment.project !== null && project !== null) await cp(join(root, moment.project), project, { recursive: true });
  const server = await startServer({ installation: installationAt(root, '0.0.0'), startPath: project, log: console.error });
  const [width = 0, height = 0] = screen.size.split('x').map(Number);
  const page = await browser.newPage({ viewport: { width, height }, colorScheme: screen.theme, reducedMotion: 'reduce' });
  const exported = join(base, EXPORTED);
  try {
    await page.goto(server.invite());
    if (project !== null) await isSettled(page);
    await moment.reach(page, exported);
    await isPainted(page);
    const path = join(folder, `${moment.name}.png`);
    if (moment.onPhone) await showOnPhone(browser, exported, screen, path);
    else await page.screenshot({ path });
  } finally {
    await page.close();
    await server.close();
  }
}

async function showOnPhone(browser: Browser, exported: string, { theme }: Screen, path: string): Promise<void> {
  const servers = createPageServers();
  const phone = await browser.newPage({ viewport: PHONE, hasTouch: true, isMobile: true, deviceScaleFactor: 2, colorScheme: theme });
  try {
    await phone.goto(await servers.serve(exported));
    await phone.getByRole('button', { name: /^(Enter AR|Use the camera)$/ }).waitFor();
    await phone.screenshot({ path });
  } finally {
    await phone.close();
    await servers.dispose();
  }
}
