import { cp, mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { _electron, type Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, timeMs } from './bench.ts';
import { openServer, startBenchBrowser } from './open-page.ts';
import { drawn } from './preview-image.ts';

const SAMPLES = 5;
const WINDOW_PX = { width: 1440, height: 900 };

/** Times of one start, milliseconds. */
interface Start {
  /** From the command to the first image of the preview. */
  readonly imageMs: number;
  /** From a click on a node to its parameters in the inspector. */
  readonly clickMs: number;
}

/**
 * What a designer waits for in the first minute, with the built editor: from the command of `npm start` to the first image of the
 * preview, and from the first click, on a node, to the first visible change, its parameters. Each start is a process of its own, with
 * an empty browser profile. In Electron only where it is installed and there is a display.
 */
export async function benches(context: ToolContext): Promise<readonly Bench[]> {
  return [...benchesOf('browser', () => startInBrowser(context)), ...benchesOf('Electron', () => startInElectron(context))];
}

function benchesOf(shell: string, start: () => Promise<Start | string>): Bench[] {
  const starts: Start[] = [];
  let missing = '';
  return [
    {
      name: `first minute in ${shell}, from npm start to the first image`,
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => {
        const started = missing === '' ? await start() : missing;
        if (typeof started === 'string') {
          missing = started;
          return Number.NaN;
        }
        starts.push(started);
        return started.imageMs;
      },
      notes: () => (missing === '' ? '' : `${shell}: ${missing}.`),
    },
    {
      name: `first minute in ${shell}, from the first click to the first change`,
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => starts.shift()?.clickMs ?? Number.NaN,
    },
  ];
}

/** Runs `work` with a copy of the project that `npm start` opens. */
async function withCopy<T>(root: string, work: (project: string) => Promise<T>): Promise<T> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  const project = join(base, 'project');
  await cp(join(root, 'examples', 'first-light'), project, { recursive: true });
  try {
    return await work(project);
  } finally {
    await rm(base, { recursive: true, force: true });
  }
}

async function clickFirst(page: Page): Promise<number> {
  const title = page.locator('.node-title', { hasText: 'Color temperature' });
  const inspector = page.getByRole('complementary', { name: 'Inspector' });
  return timeMs(async () => {
    await title.click();
    await inspector.getByRole('heading', { name: 'Color temperature' }).waitFor();
  });
}

function startInBrowser({ root }: ToolContext): Promise<Start> {
  return withCopy(root, async (project) => {
    const browser = await startBenchBrowser();
    const page = await browser.newPage({ viewport: WINDOW_PX });
    let stop = () => {};
    try {
      const imageMs = await timeMs(async () => {
        const { server, url } = await openServer(root, project);
        stop = () => void server.kill();
        await page.goto(url);
        await drawn(page);
      });
      return { imageMs, clickMs: await clickFirst(page) };
    } finally {
      await browser.close();
      stop();
    }
  });
}

async function startInElectron({ root }: ToolContext): Promise<Start | string> {
  const executablePath = await electronProgram(root);
  if (executablePath === null) return 'it is not installed; run `npm start` once, or set ELECTRON_OVERRIDE_DIST_PATH';
  if (process.platform === 'linux' && !process.env.DISPLAY && !process.env.WAYLAND_DISPLAY) return 'there is no display; use xvfb-run';
  return withCopy(root, async (project) => {
    const profile = `${project}-profile`;
    const args = ['--no-sandbox', `--user-data-dir=${profile}`, join(root, 'dist', 'electron', 'main.cjs'), `--open=${project}`];
    const { NODE_OPTIONS: _, ELECTRON_RUN_AS_NODE: __, ...env } = process.env;
    let page: Page | undefined;
    let close = async () => {};
    try {
      const imageMs = await timeMs(async () => {
        const app = await _electron.launch({ executablePath, args, env: env as Record<string, string> });
        close = () => app.close();
        page = await app.firstWindow();
        await drawn(page);
      });
      return { imageMs, clickMs: page ? await clickFirst(page) : Number.NaN };
    } finally {
      await close();
    }
  });
}

/** The program that `ELECTRON_OVERRIDE_DIST_PATH` or the npm package names; null if there is none. */
async function electronProgram(root: string): Promise<string | null> {
  const folder = join(root, 'node_modules', 'electron');
  const name = await readFile(join(folder, 'path.txt'), 'utf8').catch(() => null);
  const dist = process.env.ELECTRON_OVERRIDE_DIST_PATH;
  if (dist) return join(dist, process.platform === 'win32' ? 'electron.exe' : 'electron');
  return name === null ? null : join(folder, 'dist', name);
}
