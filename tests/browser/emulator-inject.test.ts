import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { build } from 'esbuild';
import type { Page } from 'playwright-core';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { frameOf } from '../../tools/lib/frame-of.ts';
import { collectErrors, useBrowser } from '../support/browser.ts';
import { type StaticServer, serveStatic } from '../support/serve.ts';

const CSP =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'";

const chromium = useBrowser();
let server: StaticServer;
let emulator: string;

beforeAll(async () => {
  const [injected, page] = await Promise.all([bundle('export/emulator/inject.ts'), bundle('tests/browser/emulator-inject.page.ts')]);
  emulator = injected;
  server = await serveStatic({
    '/': {
      text: `<!doctype html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${CSP}"><title>page</title><body><button>Enter AR</button><script src="/page.js"></script>`,
    },
    '/page.js': { text: page },
    '/framed': { text: '<!doctype html><meta charset="utf-8"><title>host</title><iframe sandbox="allow-scripts" src="/"></iframe>' },
  });
});
afterAll(async () => {
  await server?.close();
});

async function bundle(entry: string): Promise<string> {
  const { outputFiles } = await build({
    entryPoints: [entry],
    bundle: true,
    write: false,
    format: 'iife',
    target: 'chrome108',
    logLevel: 'silent',
  });
  return outputFiles[0]?.text ?? '';
}

interface Opened {
  readonly page: Page;
  readonly errors: string[];
  readonly warnings: string[];
}

async function open(path: string, options: EmulatorOptions): Promise<Opened> {
  const page = await chromium.browser.newPage({ viewport: { width: 320, height: 240 } });
  const errors = collectErrors(page);
  const warnings: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'warning' && !/WebGL|GPU/.test(message.text())) warnings.push(message.text());
  });
  await page.addInitScript({ content: emulator });
  await page.addInitScript((given) => {
    globalThis.scrimEmulator?.install(JSON.parse(given));
  }, JSON.stringify(options));
  await page.goto(server.origin + path);
  return { page, errors, warnings };
}

test('a page under a strict policy enters an emulated room by a click, and only by one', async () => {
  const { page, errors, warnings } = await open('/', { device: 'phone', room: 'studio', clock: 'manual', requireGesture: true });
  await page.waitForSelector('body[data-ready]');
  // Before anything is evaluated in it: that would count as a gesture.
  await page.click('button');
  await page.waitForFunction(() => globalThis.notes.entered || globalThis.notes.problem);
  const seen = await page.evaluate(async () => {
    const current = globalThis.scrimEmulator?.current;
    if (!current) throw new Error('No emulator.');
    current.setPose({ position: [0.4, 1.4, 1.6] });
    await current.frameRequested();
    await current.stepFrame(2);
    const [composite, room] = [current.readComposite(), current.readRoom()];
    const middle = (120 * 320 + 160) * 4;
    return {
      notes: globalThis.notes,
      composite: [...composite.rgba.slice(middle, middle + 3)],
      room: [...room.rgba.slice(middle, middle + 3)],
    };
  });
  expect(seen.notes).toEqual({ support: true, withoutGesture: 'SecurityError', entered: true, problem: null });
  // A quarter of green over the room.
  expect(seen.composite).toEqual(seen.room.map((value, c) => Math.round((value * 191) / 255) + (c === 1 ? 64 : 0)));
  expect(Math.max(...seen.room)).toBeGreaterThan(30);
  expect(errors).toEqual([]);
  expect(warnings).toEqual([]);
  await page.close();
});

test('a page without storage, as in a sandboxed frame, can enter too', async () => {
  const { page, errors } = await open('/framed', { device: 'headset', room: null, clock: 'manual' });
  const frame = await frameOf(page, 'iframe');
  await frame.waitForSelector('body[data-ready]');
  const state = await frame.evaluate(() => {
    try {
      return globalThis.localStorage ? 'there' : 'none';
    } catch (error) {
      return (error as Error).name;
    }
  });
  expect(state).toBe('SecurityError');
  // Granted without a gesture, and never ended: that is the session.
  expect(await frame.evaluate(() => globalThis.notes.withoutGesture)).toBe('granted');
  expect(errors).toEqual([]);
  await page.close();
});
