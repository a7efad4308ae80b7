import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from '@jest/globals';
import type { Page } from 'playwright-core';
import { TOKEN_HEADER } from '../../app/contract/http-client.ts';
import { encodeMessage, MESSAGE_TYPE } from '../../app/contract/message.ts';
import { type EditorServer, startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { useBrowser } from '../support/browser.ts';
import { projectText, writeProject } from '../support/project-kit.ts';
import { type StaticServer, serveStatic } from '../support/serve.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const chromium = useBrowser();

/** What another site in the same browser can try. */
const EVIL = '<!doctype html><title>evil</title>';

let base = '';
let server: EditorServer;
let evil: StaticServer;
let page: Page;
beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-host-'));
  const project = join(base, 'project');
  await writeProject(project, {
    'project.scrim.json': projectText({ title: 'Secret', nodes: {}, wires: [] }),
    'assets/secret.png': new Uint8Array([0x89, 0x50, 0x4e, 0x47]),
  });
  const log = (message: string) => process.stderr.write(`${message}\n`);
  server = await startServer({ installation: installationAt(ROOT, '1.2.3'), startPath: project, log });
  evil = await serveStatic({ '/': { text: EVIL } });
});
afterAll(async () => {
  await server.close();
  await evil.close();
  await rm(base, { recursive: true, force: true });
});
beforeEach(async () => {
  page = await chromium.browser.newPage();
});
afterEach(() => page.close());

async function openEditor(): Promise<void> {
  await page.goto(server.invite());
  await page.getByText('Secret').first().waitFor();
}

const MESSAGE = Buffer.from(encodeMessage({})).toString('base64');

/** Calls the host from the page's own script, with everything a caller needs but the right origin. */
function tryToCall(origin: string, token: string): Promise<string> {
  return page.evaluate(
    async ([address, secret, message, type, header]) => {
      const body = Uint8Array.from(atob(message as string), (c) => c.charCodeAt(0));
      const headers = { 'content-type': type as string, [header as string]: secret as string };
      return fetch(`${address}/api/call/app.info`, { method: 'POST', headers, body }).then(
        async (response) => `${response.status} ${await response.text()}`,
        (error: Error) => `blocked: ${error.message}`,
      );
    },
    [origin, token, MESSAGE, MESSAGE_TYPE, TOKEN_HEADER],
  );
}

describe('the editor on loopback, in a browser', () => {
  test('takes the token out of the address, and works on after a reload', async () => {
    await openEditor();
    expect(page.url()).toBe(`${server.editorOrigin}/`);
    await page.reload();
    await page.getByText('Secret').first().waitFor();
    expect(await page.evaluate(() => document.cookie)).toBe('');
  });

  test('opens in another tab of the same browser without a code, and in no other browser', async () => {
    const browser = await chromium.browser.newContext();
    const first = await browser.newPage();
    await first.goto(server.invite());
    await first.getByText('Secret').first().waitFor();
    const beside = await browser.newPage();
    await beside.goto(server.editorOrigin);
    await beside.getByText('Secret').first().waitFor();
    await browser.close();
    const stranger = await chromium.browser.newPage();
    await stranger.goto(server.editorOrigin);
    await stranger.getByText('Its code works once.').waitFor();
    await stranger.close();
  });

  test('shows nothing without the token', async () => {
    await page.goto(server.editorOrigin);
    await page.waitForLoadState('networkidle');
    expect(await page.getByText('Secret').count()).toBe(0);
    expect(await tryToCall(server.editorOrigin, '')).toMatch(/^403 /);
  });

  test('keeps its preview from the host, even with the token', async () => {
    await openEditor();
    const preview = await frameOf(page);
    expect(new URL(preview.url()).origin).toBe(server.previewOrigin);
    const call = (origin: string) =>
      preview.evaluate(
        async ([address, secret, header]) =>
          fetch(`${address}/api/call/app.info`, { method: 'POST', headers: { [header as string]: secret as string } }).then(
            (response) => String(response.status),
            () => 'blocked',
          ),
        [origin, server.token, TOKEN_HEADER],
      );
    expect(await call(server.editorOrigin)).toBe('blocked');
    expect(await call(server.previewOrigin)).toBe('405');
    expect(
      await preview.evaluate(() =>
        Promise.resolve()
          .then(() => window.parent.document.title)
          .catch(() => 'refused'),
      ),
    ).toBe('refused');
    expect(await preview.evaluate(() => 'scrimHost' in window)).toBe(false);
  });
});

describe('another site in the same browser', () => {
  test('cannot call the host, even if it knew the token', async () => {
    await page.goto(evil.origin);
    expect(await tryToCall(server.editorOrigin, server.token)).toMatch(/^blocked/);
  });

  test('cannot show the editor, or its preview, in a frame of its own', async () => {
    await page.goto(evil.origin);
    for (const url of [server.invite(), `${server.previewOrigin}/`, `${evil.origin}/`]) {
      const loaded = await page.evaluateHandle(
        (address) =>
          new Promise<HTMLIFrameElement>((done) => {
            const iframe = Object.assign(document.createElement('iframe'), { src: address, onload: () => done(iframe) });
            document.body.replaceChildren(iframe);
          }),
        url,
      );
      // The frame of this very element: the page still lists the removed one until its process reports its end.
      const frame = await loaded.contentFrame();
      const shown = await frame?.evaluate(() => window.location.protocol);
      // Its own page can be framed, so that the test can tell.
      expect([url, shown]).toEqual([url, url.startsWith(evil.origin) ? 'http:' : 'chrome-error:']);
    }
  });

  test('cannot read or even show a project’s files, if it knew their address', async () => {
    await openEditor();
    const { output } = (await server.host.dispatch('project.open', { path: join(base, 'project') })) as {
      output: { assetBaseUrl: string };
    };
    const address = `${output.assetBaseUrl}assets/secret.png`;
    await page.goto(evil.origin);
    const tried = await page.evaluate(async (url) => {
      const read = await fetch(url).then(
        () => 'read',
        () => 'blocked',
      );
      const sent = await fetch(url, { mode: 'no-cors' }).then(
        () => 'sent',
        () => 'blocked',
      );
      return [read, sent];
    }, address);
    expect(tried).toEqual(['blocked', 'blocked']);
  });
});
