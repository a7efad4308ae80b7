import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { exportProject } from '../../app/services/export-project.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { bundleEmulator } from '../lib/bundle-emulator.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile } from './bench.ts';
import { startBenchBrowser } from './open-page.ts';

/** Frames of the emulated headset per second of its time. */
const HZ = 30;
const MINUTES = 5;
/** The first second, in which all is compiled and made, is not part of the five minutes. */
const WARM_FRAMES = 30;
/** A press of the trigger every 0.6 s: after half a minute, all bodies are in the world. */
const PRESS_EVERY = 18;
const SIZE_PX = { width: 320, height: 240 };
/** A headset with depth that the page reads on the CPU, before the table on which both examples stand. */
const HEADSET = {
  device: 'headset',
  views: 1,
  clock: 'manual',
  framesPerSecond: HZ,
  antialias: false,
  display: false,
  depth: { usages: ['cpu-optimized'], formats: ['float32'], sizePx: [160, 120] },
  room: {
    boxes: [
      { label: 'floor', centerWorld: [0, -0.05, 0], sizeM: [5, 0.1, 5] },
      { label: 'table', centerWorld: [-0.2, 0.4, -0.5], sizeM: [1.4, 0.045, 0.9] },
      { label: 'wall', centerWorld: [0, 1.25, -2.5], sizeM: [5, 2.5, 0.1] },
    ],
  },
};
const TYPES: Readonly<Record<string, string>> = { html: 'text/html', js: 'text/javascript', json: 'application/json' };

/** The global of the emulated device, as far as the bench uses it. Functions that run in the page find it in `globalThis`. */
interface EmulatedPage {
  readonly scrimEmulator: {
    install(options: object): void;
    readonly current: {
      frameRequested(): Promise<void>;
      stepFrame(): Promise<void>;
      setPose(pose: object): void;
      setInput(mode: 'controllers'): void;
      readonly device: { readonly controllers: { readonly right: Controller } };
    };
  };
}

interface Controller {
  readonly position: { set(...xyz: readonly number[]): void };
  readonly quaternion: { set(...xyzw: readonly number[]): void };
  updateButtonValue(name: string, value: number): void;
}

/** Frames of a run. Times are CPU time of the page's main thread, so that other programs of a busy machine do not count. */
interface Played {
  readonly medianMs: number;
  readonly p99Ms: number;
  readonly over: number;
  readonly worstMs: number;
}

/** Examples with the number of bodies that move: cans, balls and thrown balls; marbles. */
const EXAMPLES = [
  ['tin-cans', 50],
  ['marble-run', 51],
] as const;

/** Physics examples in the emulated headset for five minutes of its time: how many frames take over twice the median. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  return EXAMPLES.filter(([e]) => e.startsWith(process.env.EX ?? '')).map(([example, count]) => {
    let played: Played | undefined;
    return {
      name: `frames over twice the median, ${example}, ${count} bodies, ${MINUTES} minutes in a headset`,
      unit: 'ratio',
      samples: 1,
      sample: async () => {
        played = await play(root, example);
        return played.over;
      },
      notes: () => {
        if (!played) return '';
        const { medianMs, p99Ms, worstMs, over } = played;
        const of = (ms: number) => ms.toFixed(1);
        return `${example}: median ${of(medianMs)} ms of CPU time, 99 % below ${of(p99Ms)} ms, worst ${of(worstMs)} ms; ${(100 * over).toFixed(2)} % over twice the median.`;
      },
    };
  });
}

async function play(root: string, example: string): Promise<Played> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-play-'));
  const browser = await startBenchBrowser();
  try {
    await exportPage(root, example, base);
    const page = await openHeadset(browser, root, join(base, 'page'));
    const times = await playFrames(page, WARM_FRAMES + MINUTES * 60 * HZ);
    const sorted = times.slice(WARM_FRAMES).sort((a, b) => a - b);
    const medianMs = quantile(sorted, 0.5);
    const over = sorted.filter((ms) => ms > 2 * medianMs).length / sorted.length;
    return { medianMs, p99Ms: quantile(sorted, 0.99), over, worstMs: quantile(sorted, 1) };
  } finally {
    await browser.close();
    await rm(base, { recursive: true, force: true });
  }
}

/** Exports an example in which the triggers of controllers tap, too: in the original, visitors of headsets throw by hand. */
async function exportPage(root: string, example: string, base: string): Promise<void> {
  const folder = join(base, 'project');
  await cp(join(root, 'examples', example), folder, { recursive: true });
  const path = join(folder, 'project.scrim.json');
  await writeFile(path, (await readFile(path, 'utf8')).replace('"by": "screen"', '"by": "any"'));
  const installation = installationAt(root, '0.0.0');
  const projectFiles = await readProjectFiles(folder);
  const { report, diagnostics } = await exportProject({ root: folder, projectFiles, out: join(base, 'page'), installation });
  if (report === null) throw new Error(`${example} cannot be exported: ${JSON.stringify(diagnostics)}`);
}

async function openHeadset(browser: Browser, root: string, folder: string): Promise<Page> {
  const page = await browser.newPage({ viewport: SIZE_PX });
  await page.addInitScript({ content: await bundleEmulator(root) });
  await page.addInitScript((given: object) => (globalThis as unknown as EmulatedPage).scrimEmulator.install(given), HEADSET);
  await page.addInitScript(drawNothing);
  await page.route('https://bench.invalid/**', async (route) => {
    const path = new URL(route.request().url()).pathname.slice(1) || 'index.html';
    const contentType = TYPES[path.split('.').at(-1) ?? ''] ?? 'application/octet-stream';
    await route.fulfill({ body: await readFile(join(folder, path)), contentType });
  });
  await page.goto('https://bench.invalid/');
  await page.getByRole('button', { name: 'Enter AR' }).click();
  await page.evaluate(() => (globalThis as unknown as EmulatedPage).scrimEmulator.current.frameRequested());
  await page.evaluate(() => {
    const emulator = (globalThis as unknown as EmulatedPage).scrimEmulator.current;
    emulator.setPose({ position: [0, 1.6, 0.4], quaternion: [-0.17, 0, 0, 0.985] });
    emulator.setInput('controllers');
  });
  return page;
}

/** CPU time of the page's main thread for each frame, milliseconds. */
async function playFrames(page: Page, count: number): Promise<number[]> {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  const threadMs = async (): Promise<number> => {
    const { metrics } = await devtools.send('Performance.getMetrics');
    return 1000 * (metrics.find(({ name }) => name === 'ThreadTime')?.value ?? Number.NaN);
  };
  const times: number[] = [];
  let before = await threadMs();
  for (let frame = 0; frame < count; frame++) {
    await page.evaluate(
      ([i, every]) => {
        const emulator = (globalThis as unknown as EmulatedPage).scrimEmulator.current;
        const { right: controller } = emulator.device.controllers;
        // Ping-pong over the middle of the table, a little downwards.
        const yawRad = 0.3 * Math.sin(i / 25);
        controller.position.set(0.1, 1.4, 0.2);
        controller.quaternion.set(-0.25, Math.sin(yawRad / 2), 0, 0.96);
        controller.updateButtonValue('trigger', i % every < 4 ? 1 : 0);
        return emulator.stepFrame();
      },
      [frame, PRESS_EVERY] as const,
    );
    const now = await threadMs();
    times.push(now - before);
    before = now;
  }
  return times;
}

/**
 * Runs in the page: what it draws stays undrawn. Without a graphics card, drawing takes longer than all else in a frame. The emulated device
 * draws depth in a context of its own.
 */
function drawNothing(): void {
  const page = globalThis as unknown as { XRWebGLLayer: new (session: object, gl: object, init?: object) => object };
  const Layer = page.XRWebGLLayer;
  page.XRWebGLLayer = class extends Layer {
    constructor(session: object, gl: object, init?: object) {
      super(session, gl, init);
      const nothing = (): void => undefined;
      Object.assign(gl, { drawArrays: nothing, drawElements: nothing, drawArraysInstanced: nothing, drawElementsInstanced: nothing });
    }
  };
}
