import { afterAll, beforeAll, expect } from '@jest/globals';
import { build } from 'esbuild';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { findChromium } from '../../app/services/chromium.ts';
import { startBrowser } from '../../app/services/start-browser.ts';
import { PATIENCE_MS } from './patience.ts';
import { type StaticServer, serveStatic } from './serve.ts';
import { decodeTransfer, encodeTransfer } from './transfer.ts';

/**
 * Starts the pinned Chromium once per test file. Goldens and pixel tests use only this browser.
 *
 * @param more Additional switches of Chromium.
 */
export function useBrowser(more: readonly string[] = []): { readonly browser: Browser } {
  let browser: Browser | undefined;
  beforeAll(async () => {
    const found = await findChromium({ pinnedOnly: true });
    if (!found) throw new Error('The pinned Chromium (@sparticuz/chromium) is missing: run `npm ci` on Linux x64.');
    browser = await startBrowser(found, more);
    browser.on('context', prepareContext);
  });
  afterAll(async () => {
    await browser?.close();
  });
  return {
    get browser() {
      if (!browser) throw new Error('The browser is only there inside tests.');
      return browser;
    },
  };
}

/**
 * Sets the timeout of pages to that of the tests, instead of Playwright’s 30 s, lets previews draw every `FREE_FRAME_MS`, and switches
 * thumbnails off in the editor.
 */
export function prepareContext(context: BrowserContext): void {
  context.setDefaultTimeout(PATIENCE_MS);
  void context.addInitScript(drawSeldom, { frameMs: FREE_FRAME_MS, embedded: true });
  void context.addInitScript(storePreferences);
  const slowness = Number(process.env.SCRIM_THROTTLE ?? 1);
  if (slowness > 1) context.on('page', (page) => void slowDown(page, slowness));
}

/**
 * Page code: the editor shows no thumbnails unless a test asks for them, because without a GPU they take much of the time of the preview. The
 * choice of a test stays when it reloads the page.
 */
function storePreferences(): void {
  if (window.top !== window || !location.protocol.match(/^(http|scrim)/)) return;
  if (localStorage.getItem('scrim-preferences') === null) localStorage.setItem('scrim-preferences', '{"thumbnails":false}');
}

/**
 * Milliseconds between two frames of a preview. Without a GPU, one that plays as fast as it can takes both cores from what is
 * tested: the tests of the editor then took three times as long.
 */
const FREE_FRAME_MS = 250;
/** The same of an exported page, whose image a test takes as soon as its texts say that it is there. */
const PAGE_FRAME_MS = 100;

/** Lets an exported page draw every `frameMs`, from its next navigation. Frames that a test steps itself are drawn at once. */
export async function drawPageSeldom(page: Page, frameMs = PAGE_FRAME_MS): Promise<void> {
  await page.addInitScript(drawSeldom, { frameMs, embedded: false });
}

/**
 * Page code, installed before its scripts: frames start at least `frameMs` apart, in embedded pages or in the page itself. What waits for
 * the screen asks `requestScreenFrame`.
 */
function drawSeldom({ frameMs, embedded }: { readonly frameMs: number; readonly embedded: boolean }): void {
  if ((window.top !== window) !== embedded) return;
  const { requestAnimationFrame: request, cancelAnimationFrame: cancel, setTimeout: start, clearTimeout: stop } = window;
  /** What ends a delayed request, by its id. Ids of the browser are positive. */
  const delayed = new Map<number, () => void>();
  let nextId = -1;
  let lastMs = -frameMs;
  Object.assign(window, { requestScreenFrame: request });
  window.requestAnimationFrame = (draw) => {
    const run = (timeMs: number) => {
      lastMs = timeMs;
      draw(timeMs);
    };
    const waitMs = lastMs + frameMs - performance.now();
    if (waitMs <= 0) return request(run);
    const id = nextId--;
    const timer = start(() => {
      const requested = request((timeMs) => {
        delayed.delete(id);
        run(timeMs);
      });
      delayed.set(id, () => cancel(requested));
    }, waitMs);
    delayed.set(id, () => stop(timer));
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    if (id >= 0) return cancel(id);
    delayed.get(id)?.();
    delayed.delete(id);
  };
}

/**
 * Throttles scripts in pages to find races: with `SCRIM_THROTTLE=6` in the environment, to a sixth of their speed, as on a slow and
 * busy machine. Ignores pages that close meanwhile.
 */
async function slowDown(page: Page, rate: number): Promise<void> {
  try {
    const devtools = await page.context().newCDPSession(page);
    await devtools.send('Emulation.setCPUThrottlingRate', { rate });
  } catch (error) {
    if (!page.isClosed()) throw error;
  }
}

/** Collects console errors and uncaught exceptions of a page. */
export function collectErrors(page: Page): string[] {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') errors.push(message.text());
  });
  return errors;
}

export interface PageModule {
  readonly page: Page;
  readonly errors: readonly string[];
  /** Calls an exported function of the bundled module in the page. Arguments and result are passed by `encodeTransfer`. */
  call<T>(name: string, ...args: readonly unknown[]): Promise<T>;
  close(): Promise<void>;
}

/** A bundled module, and what carries values to and from it. */
type TestModule = Readonly<Record<string, (...args: readonly unknown[]) => unknown>> & {
  readonly decodeTransfer: typeof decodeTransfer;
  readonly encodeTransfer: typeof encodeTransfer;
};

export interface PageOptions {
  readonly width?: number;
  readonly height?: number;
  /** Folders to serve beside the page: URL prefix → absolute folder. */
  readonly mounts?: Readonly<Record<string, string>>;
}

/** Bundles a `*.page.ts` file, serves it and opens it. `call` reaches its exports. */
export async function openModule(browser: Browser, entry: string, options: PageOptions = {}): Promise<PageModule> {
  const code = await bundleForPage(entry);
  const server: StaticServer = await serveStatic({
    ...options.mounts,
    '/': { text: '<!doctype html><meta charset="utf-8"><title>test</title><body style="margin:0"><script src="/module.js"></script>' },
    '/module.js': { text: code },
  });
  const page = await browser.newPage({ viewport: { width: options.width ?? 640, height: options.height ?? 360 } });
  const errors = collectErrors(page);
  await page.goto(server.origin);
  return {
    page,
    errors,
    call: async (name, ...args) =>
      decodeTransfer(
        await page.evaluate(
          async ([n, sent]) => {
            const module = (globalThis as unknown as { testModule: TestModule }).testModule;
            return module.encodeTransfer(await module[n]?.(...(module.decodeTransfer(sent) as unknown[])));
          },
          [name, encodeTransfer(args)] as const,
        ),
      ) as never,
    close: async () => {
      await page.close();
      await server.close();
    },
  };
}

/** Opens a bundled module in its own Chromium for all tests of a file. Console errors fail the file. */
export function useModule(entry: string, options: PageOptions = {}): PageModule {
  const chromium = useBrowser();
  let opened: PageModule | undefined;
  const module = (): PageModule => {
    if (!opened) throw new Error('The page is only there inside tests.');
    return opened;
  };
  beforeAll(async () => {
    opened = await openModule(chromium.browser, entry, options);
  });
  afterAll(async () => {
    await opened?.close();
    expect(opened?.errors ?? []).toEqual([]);
  });
  return {
    get page() {
      return module().page;
    },
    get errors() {
      return module().errors;
    },
    call: (name, ...args) => module().call(name, ...args),
    close: () => module().close(),
  };
}

async function bundleForPage(entry: string): Promise<string> {
  const result = await build({
    stdin: {
      contents: `export * from './${entry}';\nexport { decodeTransfer, encodeTransfer } from './tests/support/transfer.ts';\n`,
      resolveDir: process.cwd(),
    },
    bundle: true,
    write: false,
    format: 'iife',
    globalName: 'testModule',
    target: 'chrome108',
    define: { 'import.meta.url': 'document.baseURI' },
    // Pages that need styles import them themselves.
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text', '.css': 'empty' },
    sourcemap: 'inline',
    logLevel: 'silent',
  });
  const [file] = result.outputFiles;
  if (!file) throw new Error(`esbuild made nothing of ${entry}`);
  return file.text;
}
