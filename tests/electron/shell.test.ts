import { cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import type { ElectronApplication, Page } from 'playwright-core';
import type { Answer } from '../../app/contract/host-error.ts';
import type { HostBridge } from '../../app/contract/ipc-client.ts';
import { describeElectron, editorWindow, findElectron } from '../support/electron.ts';
import { eventually } from '../support/patience.ts';

/** The shell as it is built, with pages of the test's own: what they may do is what is asked here. */
const SHELL = resolve(import.meta.dirname, '../../dist/electron');

describeElectron('the Electron shell', await findElectron(), (launch) => {
  let base = '';
  let project = '';
  let app: ElectronApplication;
  let page: Page;

  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-shell-'));
    project = join(base, 'first');
    await cp(SHELL, join(base, 'dist', 'electron'), { recursive: true });
    await symlink(resolve(SHELL, '../../node_modules'), join(base, 'node_modules'));
    await put('dist/editor/index.html', '<!doctype html><title>Editor</title><iframe src="scrim://preview/index.html"></iframe>');
    await put('dist/preview/index.html', '<!doctype html><title>Preview</title>');
    await put('first/project.scrim.json', '{"title":"First"}\n');
    await put('first/assets/cup.glb', 'glTF');
    app = await launch([join(base, 'dist', 'electron', 'main.cjs'), `--open=${project}`]);
    page = await editorWindow(app);
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  async function put(path: string, text: string): Promise<void> {
    await mkdir(join(base, path, '..'), { recursive: true });
    await writeFile(join(base, path), text);
  }

  function call<T>(method: string, input: unknown): Promise<Answer<T>> {
    return page.evaluate(
      ([m, i]) => (window as unknown as { scrimHost: HostBridge }).scrimHost.call(m as string, i),
      [method, input],
    ) as Promise<Answer<T>>;
  }

  test('answers the editor: what to open, a project, bytes', async () => {
    expect(await call('app.info', {})).toMatchObject({
      output: { shell: 'electron', startPath: project, previewUrl: 'scrim://preview/index.html', canPickFolders: true },
    });
    const opened = await call<{ handle: string; assetBaseUrl: string }>('project.open', { path: project });
    if (!('output' in opened)) throw new Error(JSON.stringify(opened));
    const { handle, assetBaseUrl } = opened.output;
    const imported = await page.evaluate(
      (h) =>
        (window as unknown as { scrimHost: HostBridge }).scrimHost.call('asset.import', {
          handle: h,
          name: 'a.png',
          bytes: new Uint8Array([0, 200]),
        }),
      handle,
    );
    expect(imported).toEqual({ output: { path: 'assets/a.png' } });
    expect([...(await readFile(join(project, 'assets', 'a.png')))]).toEqual([0, 200]);
    // The frame is on its way to its page for a while.
    const preview = await eventually(() => {
      const found = page.frames().find((frame) => frame.url() === 'scrim://preview/index.html');
      if (!found) throw new Error('The preview has no frame.');
      return found;
    });
    expect(await preview.evaluate(async (url) => (await fetch(url)).text(), `${assetBaseUrl}assets/cup.glb`)).toBe('glTF');
  });

  test('refuses what the contract does not know', async () => {
    for (const [method, input] of [
      ['nothing', {}],
      ['__proto__', {}],
      ['project.open', { path: 7 }],
      ['project.close', { handle: '../x' }],
    ]) {
      expect(await call(method as string, input)).toMatchObject({ diagnostic: { code: 'SCR073' } });
    }
    expect(await call('project.open', { path: join(base, 'nowhere') })).toMatchObject({ diagnostic: { code: 'SCR004' } });
  });

  test('shows nothing of the disk but the project’s own files, whatever the address', async () => {
    const opened = await call<{ assetBaseUrl: string }>('project.open', { path: project });
    if (!('output' in opened)) throw new Error(JSON.stringify(opened));
    const { assetBaseUrl } = opened.output;
    await put('secret.txt', 'secret');
    await symlink(join(base, 'secret.txt'), join(project, 'assets', 'link.txt'));
    const preview = page.frames().find((frame) => frame.url() === 'scrim://preview/index.html');
    const statusOf = (url: string) => preview?.evaluate(async (address) => (await fetch(address)).status, url);
    expect(await statusOf(`${assetBaseUrl}assets/cup.glb`)).toBe(200);
    for (const path of [
      '../secret.txt',
      'assets/../../secret.txt',
      '%2e%2e/secret.txt',
      '..%2fsecret.txt',
      '%252e%252e/secret.txt',
      '..%5csecret.txt',
      'assets/link.txt',
      '.scrim/.gitignore',
      `${base}/secret.txt`,
    ]) {
      expect([path, await statusOf(`${assetBaseUrl}${path}`)]).toEqual([path, 404]);
    }
  });

  test('gives the pages nothing of Node or Electron, and the preview nothing at all', async () => {
    const names = ['require', 'process', 'module', 'Buffer', 'electron', 'ipcRenderer'];
    const globals = (list: string[]) => list.filter((name) => name in globalThis);
    expect(await page.evaluate(globals, names)).toEqual([]);
    const preview = page.frames().find((frame) => frame.url() === 'scrim://preview/index.html');
    expect(await preview?.evaluate(globals, [...names, 'scrimHost'])).toEqual([]);
    expect(await page.evaluate(() => Object.keys((window as unknown as { scrimHost: object }).scrimHost))).toEqual(['call', 'subscribe']);
    expect(await preview?.evaluate(() => window.isSecureContext)).toBe(true);
    expect(await app.evaluate(({ BrowserWindow }) => BrowserWindow.getAllWindows().length)).toBe(1);
  });

  test('stays where it is: no navigation, no windows, no network, no files', async () => {
    await page.evaluate(() => {
      window.open('https://example.com/');
      window.location.href = 'https://example.com/';
    });
    await page.evaluate(() => {
      window.location.href = 'scrim://preview/index.html';
    });
    expect(await page.evaluate(() => window.location.href)).toBe('scrim://editor/');
    expect(await app.evaluate(({ BrowserWindow }) => BrowserWindow.getAllWindows().length)).toBe(1);
    // The preview has a window of its own, which cannot call the host either.
    const opening = app.waitForEvent('window');
    await page.evaluate(() => {
      const made = window.open('about:blank', '', 'popup');
      const frame = made?.document.createElement('iframe');
      if (!made || !frame) return;
      frame.src = 'scrim://preview/index.html';
      made.document.body.append(frame);
    });
    const popup = await opening;
    expect(await popup.evaluate(() => 'scrimHost' in window)).toBe(false);
    const preview = await eventually(async () => {
      const found = popup.frames().find((frame) => frame.url() === 'scrim://preview/index.html');
      if (!found) throw new Error('The window has no preview.');
      return found;
    });
    await preview.waitForFunction(() => document.title === 'Preview');
    await popup.close();
    for (const url of ['https://example.com/', 'file:///etc/passwd', 'scrim://preview/index.html', 'http://127.0.0.1:1/']) {
      const result = await page.evaluate(
        (u) =>
          fetch(u).then(
            () => 'read',
            () => 'refused',
          ),
        url,
      );
      expect([url, result]).toEqual([url, 'refused']);
    }
  });

  test('runs no script but its own', async () => {
    const ran = await page.evaluate(async () => {
      const script = document.createElement('script');
      script.textContent = 'window.injected = true';
      document.body.append(script);
      // In a task of the page's own: what a debugger evaluates is exempt from the policy.
      const evaluated = await new Promise<boolean>((resolve) => {
        setTimeout(() => {
          try {
            resolve(new Function('return true')());
          } catch {
            resolve(false);
          }
        });
      });
      return { injected: 'injected' in window, evaluated };
    });
    expect(ran).toEqual({ injected: false, evaluated: false });
  });

  test('runs nothing of a project in the preview: no script, module or worker, whatever its name and type', async () => {
    await put('first/assets/evil.js', 'globalThis.ran = true; postMessage("ran")');
    await put('dist/preview/assets/own.js', 'globalThis.ran = true; globalThis.postMessage?.("ran")');
    const opened = await call<{ assetBaseUrl: string }>('project.open', { path: project });
    if (!('output' in opened)) throw new Error(JSON.stringify(opened));
    const preview = page.frames().find((frame) => frame.url() === 'scrim://preview/index.html');
    const run = (url: string) =>
      preview?.evaluate(async (src) => {
        // What ends in an event either way; nothing is waited for by time.
        const outcome = (start: (done: (how: string) => void) => void) =>
          new Promise<string>((resolve) => {
            try {
              start(resolve);
            } catch {
              resolve('refused');
            }
          });
        const script = (type: string) =>
          outcome((done) => {
            const element = Object.assign(document.createElement('script'), { src, type });
            element.onload = () => done('ran');
            element.onerror = () => done('refused');
            document.head.append(element);
          });
        const worker = (type: WorkerType) =>
          outcome((done) => {
            const started = new Worker(src, { type });
            started.onmessage = () => done('ran');
            started.onerror = () => done('refused');
          });
        const inBlob = outcome((done) => {
          const text = `try { importScripts(${JSON.stringify(src)}) } catch { postMessage('refused') }`;
          const started = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
          started.onmessage = ({ data }) => done(data);
          started.onerror = () => done('refused');
        });
        return Promise.all([script(''), script('module'), worker('classic'), worker('module'), inBlob]);
      }, url);
    expect(await run('scrim://preview/assets/own.js')).toEqual(['ran', 'ran', 'ran', 'ran', 'ran']);
    const refused = ['refused', 'refused', 'refused', 'refused', 'refused'];
    expect(await run(`${opened.output.assetBaseUrl}assets/evil.js`)).toEqual(refused);
    expect(await run(`${opened.output.assetBaseUrl}shaders/../assets/evil.js`)).toEqual(refused);
  });

  test('grants no device', async () => {
    const states = await page.evaluate(async () => {
      const names = ['camera', 'microphone', 'geolocation', 'notifications', 'midi'];
      return Promise.all(names.map(async (name) => (await navigator.permissions.query({ name: name as PermissionName })).state));
    });
    expect(new Set(states)).toEqual(new Set(['denied']));
  });

  test('asks the editor before it closes, and closes when told', async () => {
    await page.evaluate(() => {
      const heard: unknown[] = [];
      Object.assign(window, { heard });
      (window as unknown as { scrimHost: HostBridge }).scrimHost.subscribe((event) => heard.push(event));
    });
    const save = { command: 'file.save', label: 'Save', keybinding: 'Mod+S', enabled: true, checked: null };
    expect(await call('menu.show', { menus: [{ label: 'File', entries: [save] }] })).toEqual({ output: {} });
    await app.evaluate(({ BrowserWindow, Menu }) => {
      const file = Menu.getApplicationMenu()?.items.find((item) => item.label === '&File');
      file?.submenu?.items.find((item) => item.label === 'Save')?.click();
      BrowserWindow.getAllWindows()[0]?.close();
    });
    const heard = await page.waitForFunction(() => {
      const list = (window as unknown as { heard: unknown[] }).heard;
      return list.length === 2 ? list : null;
    });
    expect(await heard.jsonValue()).toEqual([{ kind: 'menu', command: 'file.save' }, { kind: 'close-requested' }]);
    const closed = app.waitForEvent('close');
    await call('app.close', {}).catch(() => {});
    await closed;
  });
});
