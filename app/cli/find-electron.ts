import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import process from 'node:process';

/** Path of Electron’s program, or why there is none. */
export type FoundElectron = { readonly path: string } | { readonly missing: string };

/** Time limit of a download of about 110 MB on a slow connection. Without a connection, `PROBE_MS` applies. */
const FETCH_MS = 300_000;
const PROBE_MS = 3_000;
const RETRY_MS = 24 * 3600 * 1000;

/**
 * Finds Electron: `ELECTRON_OVERRIDE_DIST_PATH`, else the download of the npm package. The package has no install script, so the
 * download is started here if it is missing, at most once a day.
 */
export async function findElectron(root: string, say: (text: string) => void): Promise<FoundElectron> {
  if (!hasDisplay()) return { missing: 'there is no display' };
  const override = process.env.ELECTRON_OVERRIDE_DIST_PATH;
  if (override) {
    const path = join(override, process.platform === 'win32' ? 'electron.exe' : 'electron');
    return existsSync(path) ? { path } : { missing: `ELECTRON_OVERRIDE_DIST_PATH has no ${path}` };
  }
  const folder = join(root, 'node_modules', 'electron');
  const manifest = await readFile(join(folder, 'package.json'), 'utf8').catch(() => null);
  if (manifest === null) return { missing: 'its npm package is not installed' };
  const { version } = JSON.parse(manifest) as { version: string };
  return (await fetched(folder)) ?? (await fetchOnce(folder, version, join(root, 'node_modules', '.cache', 'scrim'), say));
}

export function hasDisplay(): boolean {
  return process.platform !== 'linux' || Boolean(process.env.DISPLAY || process.env.WAYLAND_DISPLAY);
}

async function fetched(folder: string): Promise<FoundElectron | null> {
  const name = await readFile(join(folder, 'path.txt'), 'utf8').catch(() => null);
  const path = name === null ? null : join(folder, 'dist', name);
  return path !== null && existsSync(path) ? { path } : null;
}

async function fetchOnce(folder: string, version: string, cache: string, say: (text: string) => void): Promise<FoundElectron> {
  const note = join(cache, `electron-${version}-failed`);
  const failed = await stat(note).catch(() => null);
  const missing = { missing: 'its program could not be fetched' };
  if (failed && Date.now() - failed.mtimeMs < RETRY_MS) return missing;
  // Distinguishes a missing network from a slow one within `PROBE_MS`.
  if (await answers(version)) {
    say(`Fetching Electron ${version}, about 110 MB, once…`);
    await run(process.execPath, [join(folder, 'install.js')]);
    const found = await fetched(folder);
    if (found) return found;
    await rm(join(folder, 'dist'), { recursive: true, force: true });
  }
  await mkdir(cache, { recursive: true });
  await writeFile(note, '');
  return missing;
}

/** Whether the download server of the package responds. */
async function answers(version: string): Promise<boolean> {
  const mirror = process.env.ELECTRON_MIRROR ?? process.env.npm_config_electron_mirror;
  const url = mirror ?? `https://github.com/electron/electron/releases/download/v${version}/SHASUMS256.txt`;
  return fetch(url, { method: 'HEAD', signal: AbortSignal.timeout(PROBE_MS) }).then(
    (response) => mirror !== undefined || response.ok,
    () => false,
  );
}

function run(command: string, args: readonly string[]): Promise<void> {
  return new Promise((resolve) => {
    const child = spawn(command, args, { stdio: ['ignore', 'ignore', 'inherit'], timeout: FETCH_MS });
    child.on('error', () => resolve());
    child.on('close', () => resolve());
  });
}
