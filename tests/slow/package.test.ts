import { type ChildProcess, spawn, spawnSync } from 'node:child_process';

import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { cp, mkdtemp, readdir, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import process from 'node:process';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { type Browser, chromium, type Page } from 'playwright-core';
import type { Answer } from '../../app/contract/host-error.ts';
import type { HostBridge } from '../../app/contract/ipc-client.ts';
import { readFuses } from '../../tools/package/fuses.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { type Display, openDisplay } from '../support/display.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { describeElectron, findElectron } from '../support/electron.ts';
import { visitExportedPage } from '../support/exported-page.ts';
import { PATIENCE_MS } from '../support/patience.ts';
import { countColors } from '../support/pixels.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const electron = await findElectron();

describeElectron('the packaged app', electron, () => {
  const visitor = useBrowser();
  let base = '';
  let app = '';
  let project = '';
  let display: Display;
  const running = new Set<ChildProcess>();

  beforeAll(async () => {
    if (!('executablePath' in electron)) return;
    base = await mkdtemp(join(tmpdir(), 'scrim-packaged-'));
    const folder = dirname(electron.executablePath);
    const { version } = JSON.parse(await readFile(join(ROOT, 'node_modules/electron/package.json'), 'utf8')) as { version: string };
    const found = (await readFile(join(folder, 'version'), 'utf8')).trim().replace(/^v/, '');
    if (found !== version) process.stderr.write(`The packaged app is made with the tests' Electron ${found}, not with ${version}.\n`);
    const made = spawnSync(process.execPath, [join(ROOT, 'tools/run.mjs'), 'package/main.ts', '--electron', folder, '--out', base], {
      encoding: 'utf8',
      env: environment(),
    });
    if (made.status !== 0) throw new Error(made.stderr);
    app = made.stdout.trim().split('\n').at(-1) ?? '';
    project = join(base, 'project');
    await cp(join(ROOT, 'examples/first-light'), project, { recursive: true });
    await rm(join(project, '.scrim'), { recursive: true, force: true });
    display = await openDisplay();
  });
  afterAll(async () => {
    await end('SIGKILL');
    await display?.close();
    // Chromium's own children end a moment after it, and write to the last.
    if (base !== '') await rm(base, { recursive: true, force: true, maxRetries: 20, retryDelay: 250 });
  });

  /** As a desktop starts it, and with a door for this test: the shipped program has none for Node's debugger. */
  async function start(args: readonly string[], env: Readonly<Record<string, string>> = {}): Promise<Browser> {
    const sandbox = process.getuid?.() === 0 ? ['--no-sandbox'] : [];
    const child = spawn(join(app, 'scrim'), [...sandbox, '--remote-debugging-port=0', ...args], {
      env: environment({ DISPLAY: display.name, XDG_CONFIG_HOME: join(base, 'settings'), ...env }),
      stdio: ['ignore', 'ignore', 'pipe'],
    });
    running.add(child);
    child.once('exit', () => running.delete(child));
    let said = '';
    const address = await new Promise<string>((done, fail) => {
      child.stderr.on('data', (chunk) => {
        said += String(chunk);
        const found = /DevTools listening on (ws:\S+)/.exec(said)?.[1];
        if (found !== undefined) done(found);
      });
      child.once('exit', (code) => fail(new Error(`The app ended with ${code}.\n${said}`)));
    });
    // Electron's windows have a size of their own, which playwright's defaults would take away.
    return chromium.connectOverCDP(address, { noDefaults: true });
  }

  async function end(signal: NodeJS.Signals): Promise<void> {
    await Promise.all(
      [...running].map(async (child) => {
        const ended = once(child, 'exit');
        child.kill(signal);
        await ended;
      }),
    );
  }

  async function windowOf(browser: Browser): Promise<Page> {
    const [context] = browser.contexts();
    const page = context?.pages()[0] ?? (await context?.waitForEvent('page'));
    if (!page) throw new Error('The app opened no window.');
    page.setDefaultTimeout(PATIENCE_MS);
    // Asked of the page: playwright misses a navigation that ends while it connects, and would wait for another one.
    await page.waitForFunction(() => window.location.href === 'scrim://editor/');
    return page;
  }

  test('opens the project file it is called with, draws it, and exports its page', async () => {
    const evil = join(base, 'evil.cjs');
    await writeFile(evil, `require('node:fs').writeFileSync(${JSON.stringify(join(base, 'ran'))}, '')`);
    const browser = await start([join(project, 'project.scrim.json')], { NODE_OPTIONS: `--require ${evil}` });
    const page = await windowOf(browser);
    const errors = collectErrors(page);
    const editor = new EditorDriver(page);
    await page.locator('.react-flow__node').first().waitFor();
    await page.locator('.transport-time').filter({ hasText: /\d s/ }).waitFor();
    await editor.settled();
    expect(countColors(await editor.rewind())).toBeGreaterThan(100);

    const out = join(base, 'page');
    const exported = await page.evaluate(
      async ([path, folder]) => {
        const { scrimHost } = window as unknown as { scrimHost: HostBridge };
        const call = async (method: string, input: unknown) => {
          const answer = (await scrimHost.call(method, input)) as Answer<Record<string, unknown>>;
          if ('diagnostic' in answer) throw new Error(answer.diagnostic.message);
          return answer.output;
        };
        const { handle, files } = await call('project.open', { path });
        return call('export.run', { handle, files, out: folder });
      },
      [project, out],
    );
    // Asked of the host itself: the picture of the page is what the editor's button brings along.
    expect(exported).toMatchObject({ ok: true, diagnostics: [{ code: 'SCR065' }] });
    // The model is compressed by what lies outside the archive, too. Whether that pays is decided after it.
    const cache = join(project, '.scrim/cache');
    const models = (await readdir(cache)).filter((name) => name.startsWith('model-'));
    expect(models).toHaveLength(1);
    expect((await readFile(join(cache, models[0] ?? ''), 'latin1')).includes('EXT_meshopt_compression')).toBe(true);
    expect(errors).toEqual([]);
    // What the environment asks of Node, the fuses forbid.
    expect(existsSync(join(base, 'ran'))).toBe(false);
    await browser.close();
    await end('SIGKILL');
    await visitExportedPage(visitor.browser, out);
  });

  test('brings the terms of what it is made of, and of Electron and Chromium', async () => {
    const text = await readFile(join(app, 'THIRD-PARTY-NOTICES.txt'), 'utf8');
    for (const words of ['Eclipse Public License', 'Mozilla Public License', 'three.js authors']) expect(text).toContain(words);
    expect((await readdir(app)).filter((name) => /^LICENSE/.test(name)).length).toBeGreaterThanOrEqual(2);
  });

  test('has its fuses set', async () => {
    const fuses = await readFuses(app, 'linux');
    expect(fuses).toMatchObject({
      RunAsNode: 'off',
      EnableNodeOptionsEnvironmentVariable: 'off',
      EnableNodeCliInspectArguments: 'off',
      EnableEmbeddedAsarIntegrityValidation: 'on',
      OnlyLoadAppFromAsar: 'on',
    });
    expect(Object.values(fuses)).not.toContain(undefined);
  });

  test('holds its own code in an archive, and outside it only what pages are made from', async () => {
    const resources = join(app, 'resources');
    expect((await readdir(resources)).sort()).toEqual(['app.asar', 'app.asar.unpacked', 'desktop']);
    const outside = join(resources, 'app.asar.unpacked', 'sources');
    expect((await readdir(outside)).sort()).toEqual(['examples', 'export', 'node_modules', 'nodes', 'package.json', 'shader-library']);
    const files = await readdir(outside, { recursive: true });
    expect(files.filter((path) => /\.test\.tsx?$|\.map$|(?:^|\/)\.scrim/.test(path))).toEqual([]);
    const program = join(outside, 'node_modules', '@esbuild', `linux-${process.arch}`, 'bin', 'esbuild');
    expect((await stat(program)).mode & 0o100).toBe(0o100);
  });

  test('tells the desktop of itself, and takes that back', async () => {
    const data = join(base, 'data');
    const register = (...args: string[]) =>
      spawnSync(join(app, 'register'), args, { encoding: 'utf8', env: environment({ XDG_DATA_HOME: data }) });
    expect(register()).toMatchObject({ status: 0, stderr: '' });
    const entry = await readFile(join(data, 'applications/scrim.desktop'), 'utf8');
    expect(entry).toContain(`\nExec="${join(app, 'scrim')}" %f\n`);
    const type = /^MimeType=(.*);$/m.exec(entry)?.[1];
    const info = await readFile(join(data, 'mime/packages/scrim.xml'), 'utf8');
    expect(info).toContain(`<mime-type type="${type}">`);
    expect(info).toContain('<glob pattern="*.scrim.json"');
    expect((await readFile(join(data, 'icons/hicolor/512x512/apps/scrim.png'))).subarray(1, 4).toString()).toBe('PNG');
    expect(register('--undo')).toMatchObject({ status: 0, stderr: '' });
    const left = ['applications/scrim.desktop', 'mime/packages/scrim.xml', 'icons/hicolor/512x512/apps/scrim.png'];
    expect(left.filter((path) => existsSync(join(data, path)))).toEqual([]);
  });
});

/** Without Jest's flags for Node. */
function environment(more: Readonly<Record<string, string>> = {}): Record<string, string> {
  const { NODE_OPTIONS: _, ...rest } = process.env;
  return { ...(rest as Record<string, string>), ...more };
}
