import { cp, mkdtemp, rm } from 'node:fs/promises';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { type EditorServer, startServer } from '../../app/server/start-server.ts';
import { installationAt } from '../../app/services/installation.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile, timeMs } from './bench.ts';
import { createKeyParts, type KeyParts } from './key-parts.ts';
import { startBenchBrowser } from './open-page.ts';

const PREVIEW = 'iframe[title="Preview"]';
/** Read area: below the strip that messages may cover; small, so that reading is fast. */
const LOOK = { x: 40, y: 60, width: 24, height: 24 };

/** Time for earlier edits to be compiled and drawn. */
const REST_MS = 3000;

interface Editor {
  readonly browser: Browser;
  readonly page: Page;
}

/** Waiting times in the built editor (`npm run build`); reading the image takes some 30 ms of them. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  const project = join(base, 'project');
  await cp(join(root, 'examples', 'first-light'), project, { recursive: true });
  let started: Promise<{ server: EditorServer; browser: Browser }> | undefined;
  const options = { installation: installationAt(root, '0.0.0'), startPath: project, log: console.error };
  const start = () => {
    started ??= (async () => ({ server: await startServer(options), browser: await startBenchBrowser() }))();
    return started;
  };
  let typing: Promise<Editor> | undefined;
  const parts = createKeyParts(quantile);
  return [
    {
      name: 'editor, from its address to the first picture',
      unit: 'ms',
      samples: 5,
      sample: async () => {
        const { browser, server } = await start();
        const url = server.invite();
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
        const { browser, server } = await start();
        typing ??= openShader(browser, server.invite(), parts);
        const { page } = await typing;
        const before = await look(page);
        // A digit more or less of a factor that darkens everything.
        const ms = await timeMs(async () => {
          await page.keyboard.press(digits++ % 2 === 0 ? '5' : 'Backspace');
          while ((await look(page)).equals(before)) if (page.isClosed()) throw new Error('The editor is gone.');
        });
        await parts.take(page);
        return ms;
      },
      notes: () => `Load of the machine: ${loadavg()[0]?.toFixed(1)}\n${parts.print()}`,
      dispose: async () => {
        const { browser, server } = await start();
        await browser.close();
        await server.close();
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

/** Holds the preview and puts the cursor into a number in the filter that lies over everything. */
async function openShader(browser: Browser, url: string, parts: KeyParts): Promise<Editor> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await parts.prepare(page);
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
