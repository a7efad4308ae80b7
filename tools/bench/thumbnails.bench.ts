import type { ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { cp, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Frame, Page } from 'playwright-core';
import { frameOf } from '../lib/frame-of.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, timeMs } from './bench.ts';
import { childrenCpuMs } from './cpu-time.ts';
import { openServer, startBenchBrowser } from './open-page.ts';

const PROJECT = 'near-in-colour-far-in-ink';
const FRAMES = 20;
const SAMPLES = 7;
const CHANGES = 15;
/** Time after a change in which its last thumbnails are read. */
const REST_MS = 1000;

/**
 * Measures what thumbnails on nodes cost while a recording plays, and how long the thumbnail of a node takes to show a changed value. Passes of their own draw the layers of the thumbnails, in the frames in
 * which a thumbnail is read back. Counts the CPU time of editor and preview together if the system reports it, else wall-clock time.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<Opened> | undefined;
  const open = () => {
    opened ??= openEditor(root, PROJECT, false).then(play);
    return opened;
  };
  return [
    changeBench(root),
    {
      name: 'frame of the editor with pictures on its nodes, against none',
      unit: 'ratio',
      samples: SAMPLES,
      sample: async () => {
        const { page, preview } = await open();
        const without = await frameMs(preview);
        await showThumbnails(page, true);
        const withThumbnails = await frameMs(preview);
        await showThumbnails(page, false);
        return withThumbnails / without;
      },
      dispose: async () => {
        if (opened) await close(await opened);
      },
    },
  ];
}

/** Time from the Enter of a number to the changed thumbnail of its node, in a paused preview. */
function changeBench(root: string): Bench {
  let opened: Promise<Opened> | undefined;
  let changes = 0;
  return {
    name: 'editor, from a changed value to the changed picture on its node',
    unit: 'ms',
    samples: CHANGES,
    sample: async () => {
      opened ??= openEditor(root, 'sepia', true);
      const { page } = await opened;
      await page.locator('.node-title', { hasText: 'Sepia' }).click();
      const amount = page.getByRole('complementary', { name: 'Inspector' }).getByRole('textbox', { name: 'Amount' });
      await amount.fill(changes++ % 2 === 0 ? '0.2' : '0.9');
      await page.waitForTimeout(REST_MS);
      const before = await page.evaluate(sepiaThumbnail);
      return timeMs(async () => {
        await page.keyboard.press('Enter');
        await page.waitForFunction((old) => {
          const canvas = document.querySelector<HTMLCanvasElement>('[data-node^="filter"] .node-thumbnail canvas');
          return canvas !== null && canvas.toDataURL() !== old;
        }, before);
      });
    },
    dispose: async () => {
      if (opened) await close(await opened);
    },
  };
}

/** Runs in the page. */
function sepiaThumbnail(): string | undefined {
  return document.querySelector<HTMLCanvasElement>('[data-node^="filter"] .node-thumbnail canvas')?.toDataURL();
}

async function close({ browser, server, folder }: Opened): Promise<void> {
  await browser.close();
  server.kill();
  await once(server, 'exit');
  await rm(folder, { recursive: true, force: true });
}

interface Opened {
  readonly server: ChildProcess;
  readonly browser: Browser;
  readonly page: Page;
  readonly preview: Frame;
  readonly folder: string;
}

async function openEditor(root: string, project: string, thumbnails: boolean): Promise<Opened> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  await cp(join(root, 'examples', project), folder, { recursive: true });
  const { server, url } = await openServer(root, folder);
  const browser = await startBenchBrowser();
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.addInitScript((shown) => {
    if (window.top === window) localStorage.setItem('scrim-preferences', JSON.stringify({ thumbnails: shown }));
  }, thumbnails);
  await page.goto(url);
  await page.locator('.react-flow__node').first().waitFor();
  return { server, browser, page, preview: await frameOf(page), folder };
}

/** A project that opens for the first time stands at its first frame. */
async function play(opened: Opened): Promise<Opened> {
  const { page } = opened;
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForFunction(() => /[1-9]/.test(document.querySelector('.transport-time span')?.textContent ?? ''));
  return opened;
}

/** Switches thumbnails on or off, and waits until the change is drawn. */
async function showThumbnails(page: Page, shown: boolean): Promise<void> {
  await page.locator('.react-flow__pane').click({ position: { x: 4, y: 4 } });
  await page.keyboard.press('t');
  await page
    .locator('.node-thumbnail')
    .first()
    .waitFor({ state: shown ? 'visible' : 'detached' });
}

async function frameMs(preview: Frame): Promise<number> {
  const wall = (frames: number) =>
    preview.evaluate(
      (wanted) =>
        new Promise<number>((resolve) => {
          let left = wanted;
          const beganMs = performance.now();
          const look = () => (--left < 0 ? resolve((performance.now() - beganMs) / wanted) : requestAnimationFrame(look));
          requestAnimationFrame(look);
        }),
      frames,
    );
  // Excludes the cost of the change itself, such as compiles.
  await wall(FRAMES / 4);
  const before = childrenCpuMs();
  const wallMs = await wall(FRAMES);
  const after = childrenCpuMs();
  return before === null || after === null ? wallMs : (after - before) / FRAMES;
}
