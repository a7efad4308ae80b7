import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { exportExample, openEmulatedPage } from '../lib/emulated-page.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile } from './bench.ts';
import { startBenchBrowser } from './open-page.ts';

/** Frames of the emulated headset per second of its time. */
const HZ = 30;
const MINUTES = 5;
/** The first second, in which all is compiled and made, is not part of the five minutes. */
const WARM_FRAMES = 30;
/** Terms of a fixed calculation that takes about as long as a frame. */
const CALCULATIONS = 60_000;
/** A press of the trigger every 0.6 s: after half a minute, all bodies are in the world. */
const PRESS_EVERY = 18;
const SIZE_PX = { width: 320, height: 240 };
/** A headset with depth that the page reads on the CPU, before the table on which both examples stand. */
const HEADSET = {
  device: 'headset',
  views: 1,
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

/** The global of the emulated device, as far as the bench uses it. Functions that run in the page find it in `globalThis`. */
interface EmulatedPage {
  readonly scrimEmulator: {
    readonly current: {
      stepFrame(): Promise<void>;
      setPose(pose: object): void;
      setDepth(state: 'frozen'): void;
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

/**
 * Times of frames are CPU time of the page's main thread. The threads of other programs do not count, but they slow the page down: caches and
 * cores are shared. How much, a fixed calculation after each frame tells.
 */
interface Times {
  readonly framesMs: number[];
  readonly fixedMs: number[];
}

interface Spread {
  readonly medianMs: number;
  readonly p99Ms: number;
  /** The part that is over twice the median. */
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
  return EXAMPLES.map(([example, count]) => {
    let played: { readonly frames: Spread; readonly fixed: Spread } | undefined;
    return {
      name: `frames over twice the median, ${example}, ${count} bodies, ${MINUTES} minutes in a headset`,
      unit: 'ratio',
      samples: 1,
      sample: async () => {
        const { framesMs, fixedMs } = await play(root, example);
        played = { frames: spreadOf(framesMs.slice(WARM_FRAMES)), fixed: spreadOf(fixedMs.slice(WARM_FRAMES)) };
        return played.frames.over;
      },
      notes: () => (played ? `${example}: frames ${textOf(played.frames)}; a fixed calculation ${textOf(played.fixed)}.` : ''),
    };
  });
}

function spreadOf(times: readonly number[]): Spread {
  const sorted = [...times].sort((a, b) => a - b);
  const medianMs = quantile(sorted, 0.5);
  const over = sorted.filter((ms) => ms > 2 * medianMs).length / sorted.length;
  return { medianMs, p99Ms: quantile(sorted, 0.99), over, worstMs: quantile(sorted, 1) };
}

function textOf({ medianMs, p99Ms, worstMs, over }: Spread): string {
  const of = (ms: number) => ms.toFixed(1);
  return `median ${of(medianMs)} ms of CPU time, 99 % below ${of(p99Ms)} ms, worst ${of(worstMs)} ms, ${(100 * over).toFixed(2)} % over twice the median`;
}

async function play(root: string, example: string): Promise<Times> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-play-'));
  const browser = await startBenchBrowser();
  try {
    // The triggers of controllers tap, too: in the original, visitors of headsets throw by hand.
    const folder = await exportExample(root, example, base, (text) => text.replace('"by": "screen"', '"by": "any"'));
    const page = await openHeadset(browser, root, folder);
    return await playFrames(page, WARM_FRAMES + MINUTES * 60 * HZ);
  } finally {
    await browser.close();
    await rm(base, { recursive: true, force: true });
  }
}

async function openHeadset(browser: Browser, root: string, folder: string): Promise<Page> {
  const page = await openEmulatedPage(browser, { root, folder, sizePx: SIZE_PX, device: HEADSET, script: drawNothing });
  await page.evaluate(() => {
    const emulator = (globalThis as unknown as EmulatedPage).scrimEmulator.current;
    emulator.setPose({ position: [0, 1.6, 0.4], quaternion: [-0.17, 0, 0, 0.985] });
    emulator.setInput('controllers');
  });
  return page;
}

async function playFrames(page: Page, count: number): Promise<Times> {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  let before = 0;
  /** CPU time of the page's main thread since the last call, milliseconds. */
  const spentMs = async (): Promise<number> => {
    const { metrics } = await devtools.send('Performance.getMetrics');
    const now = 1000 * (metrics.find(({ name }) => name === 'ThreadTime')?.value ?? Number.NaN);
    const spent = now - before;
    before = now;
    return spent;
  };
  const times: Times = { framesMs: [], fixedMs: [] };
  await spentMs();
  for (let frame = 0; frame < count; frame++) {
    if (frame === WARM_FRAMES) await page.evaluate(keepDepth);
    await page.evaluate(playFrame, [frame, PRESS_EVERY] as const);
    times.framesMs.push(await spentMs());
    await page.evaluate(calculate, CALCULATIONS);
    times.fixedMs.push(await spentMs());
  }
  return times;
}

/** Runs in the page. */
function playFrame([i, every]: readonly [number, number]): Promise<void> {
  const emulator = (globalThis as unknown as EmulatedPage).scrimEmulator.current;
  const { right: controller } = emulator.device.controllers;
  // Ping-pong over the middle of the table, a little downwards.
  const yawRad = 0.3 * Math.sin(i / 25);
  controller.position.set(0.1, 1.4, 0.2);
  controller.quaternion.set(-0.25, Math.sin(yawRad / 2), 0, 0.96);
  controller.updateButtonValue('trigger', i % every < 4 ? 1 : 0);
  return emulator.stepFrame();
}

/**
 * Runs in the page. As the head stands still, depth stays the same: each frame gives the page the image that was measured last, without
 * waiting for a drawing of it.
 */
function keepDepth(): void {
  (globalThis as unknown as EmulatedPage).scrimEmulator.current.setDepth('frozen');
}

/** Runs in the page. */
function calculate(count: number): number {
  let sum = 0;
  for (let i = 1; i < count; i++) sum += Math.sin(sum + i);
  return sum;
}

/**
 * Runs in the page: what it draws stays undrawn. Without a graphics card, drawing takes longer than all else in a frame. Nor does the emulated
 * device ask for the state of the context in each frame, because it would wait for the driver. It draws depth in a context of its own.
 */
function drawNothing(): void {
  const page = globalThis as unknown as { XRWebGLLayer: new (session: object, gl: object, init?: object) => object };
  const Layer = page.XRWebGLLayer;
  page.XRWebGLLayer = class extends Layer {
    constructor(session: object, gl: object, init?: object) {
      super(session, gl, init);
      const nothing = (): void => undefined;
      const drawing = { drawArrays: nothing, drawElements: nothing, drawArraysInstanced: nothing, drawElementsInstanced: nothing };
      const { getParameter } = gl as WebGLRenderingContext;
      const known = new Map<number, unknown>();
      const ask = (name: number): unknown => {
        if (!known.has(name)) known.set(name, getParameter.call(gl, name));
        return known.get(name);
      };
      Object.assign(gl, drawing, { getParameter: ask, isFramebuffer: () => true });
    }
  };
}
