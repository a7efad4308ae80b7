import { type ChildProcess, spawn } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import type { Browser, Page } from 'playwright-core';
import { bundleScript } from '../../app/services/bundle-script.ts';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';

const ORIGIN = 'http://bench.invalid/';

/** Starts the headless browser of all benches. */
export async function startBenchBrowser(): Promise<Browser> {
  const found = await findChromium();
  if (found === null) throw new Error('No browser was found to measure in. Install Chromium, or name its program in SCRIM_CHROMIUM.');
  return startBrowser(found);
}

/** Opens an empty page with the exports of a script as the global `bench`, and the files of a folder beside it. */
export async function openPage(browser: Browser, root: string, entry: string, folder: string): Promise<Page> {
  const script = await bundleScript(root, entry, 'bench');
  const page = await browser.newPage();
  await page.route(`${ORIGIN}**`, async (route) => {
    const path = new URL(route.request().url()).pathname.slice(1);
    if (path === '') return route.fulfill({ contentType: 'text/html', body: '<!doctype html><script src="bench.js"></script>' });
    if (path === 'bench.js') return route.fulfill({ contentType: 'text/javascript', body: script });
    return route.fulfill({ body: await readFile(join(folder, path)) });
  });
  await page.goto(ORIGIN);
  return page;
}

/** Calls an export of the script that `openPage` loaded. */
export function call<T>(page: Page, name: string, ...args: readonly unknown[]): Promise<T> {
  return page.evaluate(
    ([n, a]) => (globalThis as unknown as { bench: Record<string, (...x: readonly unknown[]) => unknown> }).bench[n]?.(...a),
    [name, args] as const,
  ) as Promise<T>;
}

/** Starts the editor on loopback as `scrim open` does, and returns its address. */
export async function openServer(root: string, project: string): Promise<{ server: ChildProcess; url: string }> {
  const server = spawn(process.execPath, [join(root, 'bin', 'scrim.mjs'), 'open', project, '--browser'], {
    env: { ...process.env, DISPLAY: '', BROWSER: 'none' },
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const end = () => server.kill();
  process.once('exit', end);
  server.once('exit', () => process.off('exit', end));
  for await (const line of createInterface(server.stdout)) {
    const url = /http:\/\/127\S+/.exec(line)?.[0];
    if (url !== undefined) return { server, url };
  }
  throw new Error('The editor did not start.');
}
