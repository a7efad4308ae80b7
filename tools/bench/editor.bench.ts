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
import { changed, drawn, look } from './preview-image.ts';

/** Pause in which earlier edits are compiled and drawn. */
const REST_MS = 3000;

/**
 * How long a user of the built editor (`npm run build`) waits for the first image, and for a changed image after a key press. Reading the
 * image takes some 30 ms of each time.
 */
export async function benches(context: ToolContext): Promise<readonly Bench[]> {
  return [
    startBench(context),
    typingBench(context, 'editor, from a key in a shader to another picture', 'first-light', 'Color temperature'),
    typingBench(context, 'editor, from a key in a filter of one pass to another image', 'sepia', 'Sepia'),
  ];
}

function startBench(context: ToolContext): Bench {
  const host = createHost(context, 'first-light');
  return {
    name: 'editor, from its address to the first picture',
    unit: 'ms',
    samples: 5,
    sample: async () => {
      const { browser, server } = await host.start();
      const url = server.invite();
      const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
      const ms = await timeMs(async () => {
        await page.goto(url);
        await drawn(page);
      });
      await page.close();
      return ms;
    },
    dispose: host.dispose,
  };
}

/** Time from a key press in the shader of the node with the title `node`, in a copy of `example`, to the changed image. */
function typingBench(context: ToolContext, name: string, example: string, node: string): Bench {
  const host = createHost(context, example);
  const parts = createKeyParts(quantile);
  let typing: Promise<Page> | undefined;
  return {
    name,
    unit: 'ms',
    samples: 20,
    sample: async () => {
      const { browser, server } = await host.start();
      typing ??= openShader(browser, server.invite(), node, parts);
      const page = await typing;
      const before = await look(page);
      // A digit more or less of a factor that darkens everything.
      const ms = await timeMs(async () => {
        await page.keyboard.press(digits++ % 2 === 0 ? '5' : 'Backspace');
        await changed(page, before);
      });
      await parts.take(page);
      return ms;
    },
    notes: () => `Load of the machine: ${loadavg()[0]?.toFixed(1)}\n${parts.print()}`,
    dispose: host.dispose,
  };
}

/** A server of the editor with a copy of an example, and a browser; both start at the first use. */
function createHost({ root }: ToolContext, example: string) {
  let started: Promise<{ readonly base: string; readonly server: EditorServer; readonly browser: Browser }> | undefined;
  return {
    start: () => {
      started ??= (async () => {
        const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
        const project = join(base, 'project');
        await cp(join(root, 'examples', example), project, { recursive: true });
        const server = await startServer({ installation: installationAt(root, '0.0.0'), startPath: project, log: console.error });
        return { base, server, browser: await startBenchBrowser() };
      })();
      return started;
    },
    dispose: async () => {
      if (!started) return;
      const { base, server, browser } = await started;
      await browser.close();
      await server.close();
      await rm(base, { recursive: true, force: true });
    },
  };
}

let digits = 0;

/** Puts the cursor into a number at the end of a filter's shader. */
async function openShader(browser: Browser, url: string, node: string, parts: KeyParts): Promise<Page> {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await parts.prepare(page);
  await page.goto(url);
  await drawn(page);
  await page.locator('.node-title', { hasText: node }).click();
  await page.getByRole('button', { name: 'Edit shader', exact: true }).click();
  await page.locator('.monaco-editor .view-line').first().waitFor();
  await page.locator('.code-text').click({ position: { x: 300, y: 60 } });
  await page.keyboard.press('Control+End');
  for (const key of ['ArrowUp', 'ArrowUp', 'End']) await page.keyboard.press(key);
  await page.keyboard.type(' gl_FragColor.rgb *= 0.7;');
  await page.keyboard.press('ArrowLeft');
  await page.waitForTimeout(REST_MS);
  return page;
}
