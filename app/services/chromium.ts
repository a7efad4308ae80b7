import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, rename, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { homedir } from 'node:os';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';

const run = promisify(execFile);

/** A browser for rendering, with its switches for headless mode and WebGL 2 on the CPU. */
export interface Chromium {
  readonly executablePath: string;
  readonly args: readonly string[];
  readonly env: Readonly<Record<string, string>>;
  /** Whether it is the pinned browser, whose pixels the goldens contain. */
  readonly pinned: boolean;
}

/**
 * `--disable-gpu` with `--enable-unsafe-swiftshader` restricts SwiftShader to WebGL; the page is composited without it. Dragging
 * 1,000 nodes takes 17 ms per frame instead of 50 ms with `--use-angle=swiftshader`.
 */
const ARGS = [
  '--no-sandbox',
  '--disable-gpu',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
  '--no-first-run',
  '--force-color-profile=srgb',
  '--font-render-hinting=none',
];

const SYSTEM_BROWSERS = [
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/usr/bin/google-chrome-stable',
  '/usr/bin/google-chrome',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  'C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe',
];

/**
 * Finds a browser: `SCRIM_CHROMIUM`, else the pinned one of the npm package (Linux x64), else one of the system. With `pinnedOnly`,
 * only that of the package.
 */
export async function findChromium(options: { pinnedOnly?: boolean } = {}): Promise<Chromium | null> {
  const chosen = process.env.SCRIM_CHROMIUM;
  if (chosen && !options.pinnedOnly) return { executablePath: chosen, args: ARGS, env: {}, pinned: false };
  const pinned = await unpackPinned();
  if (pinned || options.pinnedOnly) return pinned;
  const system = SYSTEM_BROWSERS.find((path) => existsSync(path));
  return system ? { executablePath: system, args: ARGS, env: {}, pinned: false } : null;
}

/**
 * Unpacks the browser of the npm package once, into a cache folder named after its version. The package itself unpacks into the
 * temporary folder and reuses any `chromium` there, whatever its version.
 */
async function unpackPinned(): Promise<Chromium | null> {
  if (process.platform !== 'linux' || process.arch !== 'x64') return null;
  const packageDir = findPackage('@sparticuz/chromium');
  if (packageDir === null) return null;
  const { version } = createRequire(import.meta.url)(join(packageDir, 'package.json')) as { version: string };
  const dir = join(process.env.XDG_CACHE_HOME || join(homedir(), '.cache'), 'scrim', `chromium-${version}`);
  if (!existsSync(dir)) await unpack(packageDir, dir);
  return {
    executablePath: join(dir, 'chromium'),
    args: ARGS,
    // NSS and expat for systems that lack them. A single font, so that text looks the same everywhere.
    env: { LD_LIBRARY_PATH: join(dir, 'al2023', 'lib'), FONTCONFIG_FILE: await writeFontList(dir) },
    pinned: true,
  };
}

/**
 * Writes a font configuration. That of the package refers to folders of a cloud function, and without fonts Chromium crashes at the
 * first text field (Skia, `SkFontMgr_FontConfigInterface`: "Not implemented").
 */
async function writeFontList(dir: string): Promise<string> {
  const path = join(dir, 'scrim-fonts.conf');
  if (existsSync(path)) return path;
  const temporary = `${path}.${process.pid}`;
  const fonts = `<dir>${join(dir, 'fonts', 'fonts')}</dir><cachedir>${join(dir, 'font-cache')}</cachedir>`;
  await writeFile(temporary, `<?xml version="1.0"?>\n<!DOCTYPE fontconfig SYSTEM "fonts.dtd">\n<fontconfig>${fonts}</fontconfig>\n`);
  await rename(temporary, path);
  return path;
}

/**
 * Unpacks in a separate process, because the package reads `os.tmpdir()`, and renames at the end, because two processes may unpack at
 * once.
 */
async function unpack(packageDir: string, dir: string): Promise<void> {
  await mkdir(dirname(dir), { recursive: true });
  const temporary = await mkdtemp(`${dir}.`);
  const script = `
    import chromium, { inflate } from '@sparticuz/chromium';
    await chromium.executablePath();
    await inflate(${JSON.stringify(join(packageDir, 'bin', 'al2023.tar.br'))});`;
  try {
    await run(process.execPath, ['--input-type=module', '-e', script], { cwd: packageDir, env: { ...process.env, TMPDIR: temporary } });
    await rename(temporary, dir);
  } catch (error) {
    if (!existsSync(join(dir, 'chromium'))) throw error;
  } finally {
    await rm(temporary, { recursive: true, force: true });
  }
}

function findPackage(name: string): string | null {
  for (const base of createRequire(import.meta.url).resolve.paths(name) ?? []) {
    if (existsSync(join(base, name, 'package.json'))) return join(base, name);
  }
  return null;
}
