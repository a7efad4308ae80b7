import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { afterEach, expect, test } from '@jest/globals';
import type { CDPSession } from 'playwright-core';
import type { Program } from '../../export/program/program.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';
import { compileText } from '../support/compile-project.ts';
import { projectText } from '../support/project-kit.ts';

const chromium = useBrowser();
let page: PageModule | null = null;
afterEach(async () => {
  const errors = page?.errors ?? [];
  await page?.close();
  page = null;
  expect(errors).toEqual([]);
});

/** A third of what a device draws, so that the hour passes in a third of the time. */
const FRAMES_PER_S = 20;
const HOUR = 3600 * FRAMES_PER_S;

/**
 * What a browser keeps for itself moves by tens of kilobytes, most of it machine code. One number left behind in each frame of an
 * hour would be 0.6 MB.
 */
const HOUR_BYTES = 256 * 1024;
/** A matrix left behind in each frame is more than twice that. */
const BYTES_PER_FRAME = 160;

/** Values and pulses of all kinds that keep something over frames, and pictures that do. */
const VALUES = projectText({
  nodes: {
    'time-a1b2': 'value/time',
    'every-a1b2': ['pulse/every', { periodS: 0.5 }],
    'counter-a1b2': 'value/counter',
    'random-a1b2': 'value/random',
    'noise-a1b2': 'value/noise',
    'spring-a1b2': 'value/spring',
    'smooth-a1b2': 'value/smooth',
    'delay-a1b2': ['value/delay', { delayS: 0.25 }],
    'sum-a1b2': 'value/math',
    'mean-a1b2': 'value/math',
    'video-a1b2': 'source/camera-video',
    'sepia-a1b2': 'filter/sepia',
    'blur-a1b2': 'filter/gaussian-blur',
    'screen-a1b2': 'output/screen',
  },
  wires: [
    'every-a1b2.pulse -> counter-a1b2.up',
    'every-a1b2.pulse -> random-a1b2.draw',
    'time-a1b2.seconds -> noise-a1b2.along',
    'noise-a1b2.number -> spring-a1b2.number',
    'spring-a1b2.result -> smooth-a1b2.number',
    'smooth-a1b2.result -> delay-a1b2.number',
    'delay-a1b2.result -> sum-a1b2.a',
    'counter-a1b2.number -> sum-a1b2.b',
    'sum-a1b2.result -> mean-a1b2.a',
    'random-a1b2.number -> mean-a1b2.b',
    'mean-a1b2.result -> sepia-a1b2.amount',
    'video-a1b2.layer -> sepia-a1b2.inputImage',
    'sepia-a1b2.layer -> blur-a1b2.inputImage',
    'blur-a1b2.layer -> screen-a1b2.layer',
  ],
});

interface Moment {
  readonly spied: Readonly<Record<string, number>>;
  readonly gl: unknown;
  readonly player: unknown;
  readonly heapBytes: number;
}

interface Run {
  readonly program: Program;
  readonly assetUrl: string;
  readonly watched: readonly string[];
  /** When everything has been compiled, cached and made room for. */
  readonly warmFrames: number;
  readonly frames: number;
}

/** What there is when all is warm, and at the end. */
async function run({ program, assetUrl, watched, warmFrames, frames }: Run): Promise<readonly [Moment, Moment]> {
  const opened = await openModule(chromium.browser, 'tests/browser/robustness.page.ts', {
    mounts: { '/examples/': join(process.cwd(), 'examples') },
  });
  page = opened;
  const devtools = await opened.page.context().newCDPSession(opened.page);
  await opened.call('startRun', program, assetUrl, watched);
  let last: Omit<Moment, 'heapBytes'> | null = null;
  const until = async (from: number, to: number): Promise<Moment> => {
    // In pieces, so that the page lives meanwhile.
    for (let at = from; at < to; at += FRAMES_PER_S * 10) {
      last = await opened.call('runFrames', at, Math.min(FRAMES_PER_S * 10, to - at), FRAMES_PER_S);
    }
    if (last === null) throw new Error('Nothing was played.');
    return { ...last, heapBytes: await heapBytes(devtools) };
  };
  return [await until(0, warmFrames), await until(warmFrames, frames)];
}

async function heapBytes(devtools: CDPSession): Promise<number> {
  await devtools.send('HeapProfiler.enable');
  await devtools.send('HeapProfiler.collectGarbage');
  const { usedSize } = await devtools.send('Runtime.getHeapUsage');
  await devtools.send('HeapProfiler.disable');
  return usedSize;
}

function expectNoGrowth([early, late]: readonly [Moment, Moment], limitBytes: number): void {
  expect({ gl: late.gl, player: late.player }).toEqual({ gl: early.gl, player: early.player });
  expect(late.heapBytes - early.heapBytes).toBeLessThan(limitBytes);
}

test('after an hour of values, pulses and filters nothing has grown, and time is exact', async () => {
  const watched = ['time-a1b2.seconds', 'counter-a1b2.number', 'spring-a1b2.result', 'random-a1b2.number'];
  const moments = await run({ program: compileText(VALUES), assetUrl: 'examples/', watched, warmFrames: HOUR / 10, frames: HOUR });
  expectNoGrowth(moments, HOUR_BYTES);
  const { spied } = moments[1];
  expect(spied['time-a1b2.seconds']).toBe((HOUR - 1) / FRAMES_PER_S);
  // One every half second, none of them lost or doubled.
  expect(spied['counter-a1b2.number']).toBe(2 * 3600 - 1);
  // The noise that it depends on stays between -1 and 1 and accumulates no error.
  expect(Math.abs(spied['spring-a1b2.result'] ?? Number.NaN)).toBeLessThan(2);
  expect(spied['random-a1b2.number']).toBeGreaterThanOrEqual(0);
  expect(spied['random-a1b2.number']).toBeLessThan(1);
});

test('after thousands of frames of models, shadows and occlusion nothing has grown', async () => {
  // Of smaller shadow maps, which without a GPU take most of a frame, as many objects are made and kept.
  const project = JSON.parse(await readFile('examples/first-light/project.scrim.json', 'utf8'));
  project.graphs.main.nodes['sun-l5gt'].params.mapSize = '512';
  const program = compileText(JSON.stringify(project));
  const assetUrl = 'examples/first-light/';
  const warmFrames = 900;
  const frames = 2700;
  expectNoGrowth(await run({ program, assetUrl, watched: [], warmFrames, frames }), (frames - warmFrames) * BYTES_PER_FRAME);
});
