import type { ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, timeMs } from './bench.ts';
import { startBenchBrowser } from './open-page.ts';
import { openServer } from './open-server.ts';

const PREVIEW = 'iframe[title="Preview"]';
/** Read area: below the strip that messages may cover; small, so that reading is fast. */
const LOOK = { x: 40, y: 60, width: 24, height: 24 };

/** Time for earlier edits to be compiled and drawn. */
const REST_MS = 3000;

interface Editor {
  readonly browser: Browser;
  readonly page: Page;
}

/** Delays in the editor. Reading the image accounts for about 30 ms of each. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  const project = join(base, 'project');
  await cp(join(root, 'examples', 'first-light'), project, { recursive: true });
  let started: Promise<{ server: ChildProcess; url: string; browser: Browser }> | undefined;
  const start = () => {
    started ??= (async () => ({ ...(await openServer(root, project)), browser: await startBenchBrowser() }))();
    return started;
  };
  let typing: Promise<Editor> | undefined;
  return [
    {
      name: 'editor, from its address to the first picture',
      unit: 'ms',
      samples: 5,
      sample: async () => {
        const { browser, url } = await start();
        const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
        const ms = await timeMs(async () => {
          await page.goto(url);
          await drawn(page);
        });
        await page.close();
        return ms;
      },
    },
    {
      name: 'editor, from a key in a shader to another picture',
      unit: 'ms',
      samples: 20,
      sample: async () => {
        const { browser, url } = await start();
        typing ??= openShader(browser, url);
        const { page } = await typing;
        const before = await look(page);
        // Adds or removes a digit of a factor that darkens the image.
        return timeMs(async () => {
          await page.keyboard.press(digits++ % 2 === 0 ? '5' : 'Backspace');
          while ((await look(page)).equals(before)) if (page.isClosed()) throw new Error('The editor is gone.');
        });
      },
      dispose: async () => {
        const { browser, server } = await start();
        await browser.close();
        server.kill();
        await once(server, 'exit');
        await rm(base, { recursive: true, force: true });
      },
    },
  ];
}

let digits = 0;

async function drawn(page: Page): Promise<void> {
  await page.locator(PREVIEW).waitFor();
  const gray = await look(page);
  while ((await look(page)).equals(gray)) if (page.isClosed()) throw new Error('The editor is gone.');
}

async function look(page: Page): Promise<Buffer> {
  const box = await page.locator(PREVIEW).boundingBox();
  if (!box) throw new Error('There is no preview.');
  return page.screenshot({ clip: { ...LOOK, x: box.x + LOOK.x, y: box.y + LOOK.y } });
}

/** Pauses the preview and puts the caret into a number of the last filter. */
async function openShader(browser: Browser, url: string): Promise<Editor> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(url);
  await drawn(page);
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
  await page.locator('.node-title', { hasText: 'Color temperature' }).click();
  await page.getByRole('button', { name: 'Edit shader', exact: true }).click();
  await page.locator('.monaco-editor .view-line').first().waitFor();
  await page.locator('.code-text').click({ position: { x: 300, y: 60 } });
  await page.keyboard.press('Control+End');
  for (const key of ['ArrowUp', 'ArrowUp', 'End']) await page.keyboard.press(key);
  await page.keyboard.type(' gl_FragColor.rgb *= 0.7;');
  await page.keyboard.press('ArrowLeft');
  await page.waitForTimeout(REST_MS);
  return { browser, page };
}
