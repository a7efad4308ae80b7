import { tmpdir } from 'node:os';
import type { Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Weights } from './pages/capture.page.ts';

const VERTICES = 200_000;
const VIEWS = 50;
const FRAMES = 30;
const SAMPLES = 3;

/** Milliseconds of a frame of a lumigraph at 640 × 480, and what its weights per vertex cost. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<{ readonly page: Page; readonly close: () => Promise<void> }> | undefined;
  let users = 0;
  const open = async () => {
    const browser = await startBenchBrowser();
    const page = await openPage(browser, root, 'tools/bench/pages/capture.page.ts', tmpdir());
    await call(page, 'open', VERTICES, VIEWS, FRAMES);
    return { page, close: () => browser.close() };
  };
  const frame = async (weights: Weights): Promise<number> => {
    opened ??= open();
    return call<number>((await opened).page, 'frame', weights);
  };
  const of = `${VERTICES / 1000},000 vertices, ${VIEWS} photographs`;
  const measured = (name: string, unit: Bench['unit'], sample: () => Promise<number>): Bench => {
    users++;
    return {
      name,
      unit,
      samples: SAMPLES,
      sample,
      dispose: async () => {
        if (--users === 0) await (await opened)?.close();
      },
    };
  };
  return [
    measured(`draw a capture, ${of}, weights per pixel`, 'ms', () => frame('pixel')),
    measured(`draw a capture, ${of}, weights per vertex that are there`, 'ms', () => frame('kept')),
    measured(`compute weights, ${of}`, 'ms', () => frame('all')),
    measured(`compute weights, ${of}, window of ${FRAMES} frames`, 'ms', () => frame('window')),
    measured(
      `weights of a window against all, ${of}, ${FRAMES} frames`,
      'ratio',
      async () => (await frame('window')) / (await frame('all')),
    ),
  ];
}
