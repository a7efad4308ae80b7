import type { Browser, Page } from 'playwright-core';
import type { Point } from '../lib/center-of.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { openGraph, zoomToNode } from './graph-page.ts';
import { GRID_ROWS, gridGraph } from './grid-graph.ts';
import { startBenchBrowser } from './open-page.ts';

const FRAMES = 120;
/** Distance between pointer moves, as in a manual drag. */
const STEP_PX = 3;

interface Case {
  readonly name: string;
  readonly nodes: number;
  /** Number of dragged columns; 0 for one node, zoomed in. */
  readonly columns: number;
}

const CASES: readonly Case[] = [
  { name: 'dragging 25 of 50 nodes, all in view', nodes: 50, columns: 1 },
  { name: 'dragging 100 of 1,000 nodes, all in view', nodes: 1000, columns: 4 },
  { name: 'dragging one of 50 nodes, zoomed in', nodes: 50, columns: 0 },
  { name: 'dragging one of 1,000 nodes, zoomed in', nodes: 1000, columns: 0 },
];

/** Smoothness of the canvas: times between paints during a drag, while the preview is paused. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let browser: Browser | undefined;
  return CASES.map((what, index): Bench => {
    let frames: number[] | undefined;
    return {
      name: `canvas, frame while ${what.name}`,
      unit: 'ms',
      samples: FRAMES,
      sample: async () => {
        browser ??= await startBenchBrowser();
        frames ??= await framesOf(root, browser, what);
        return frames.pop() ?? Number.NaN;
      },
      dispose: async () => {
        if (index === CASES.length - 1) await browser?.close();
      },
    };
  });
}

async function framesOf(root: string, browser: Browser, what: Case): Promise<number[]> {
  const { page, close } = await openGraph(root, browser, gridGraph(what.nodes));
  try {
    const from = what.columns === 0 ? await zoomToNode(page, 'node-a2') : await selectColumns(page, what.columns);
    return await drag(page, from);
  } finally {
    await close();
  }
}

/** Selects columns in the middle with a selection box. Returns a point in the selection. */
async function selectColumns(page: Page, columns: number): Promise<Point> {
  const box = await page.evaluate((count) => {
    const boxes = [...document.querySelectorAll('.react-flow__node')].map((element) => element.getBoundingClientRect());
    const lefts = [...new Set(boxes.map(({ left }) => Math.round(left)))].sort((a, b) => a - b);
    const first = Math.floor((lefts.length - count) / 2);
    const [from = 0, to = 0] = [lefts[first], lefts[first + count - 1]];
    const wanted = boxes.filter(({ left }) => left > from - 2 && left < to + 2);
    const edge = (side: 'left' | 'top' | 'right' | 'bottom', pick: (...values: number[]) => number) => pick(...wanted.map((b) => b[side]));
    return { left: edge('left', Math.min), top: edge('top', Math.min), right: edge('right', Math.max), bottom: edge('bottom', Math.max) };
  }, columns);
  await page.mouse.move(box.right + 3, box.top - 6);
  await page.mouse.down();
  await page.mouse.move(box.left + 3, box.bottom - 1, { steps: 4 });
  await page.mouse.up();
  await page.getByRole('heading', { name: new RegExp(`^${columns * GRID_ROWS} nodes`) }).waitFor();
  return { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 };
}

/** Milliseconds between paints while the pointer moves back and forth. */
async function drag(page: Page, from: Point): Promise<number[]> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x - 12, from.y, { steps: 3 });
  await page.evaluate((wanted) => {
    const times: number[] = [];
    Object.assign(window, { benchFrames: times });
    const look = (nowMs: number) => {
      times.push(nowMs);
      if (times.length <= wanted) requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  }, FRAMES + 1);
  const count = () => page.evaluate(() => (window as unknown as { benchFrames: number[] }).benchFrames.length);
  for (let at = 0; at % 40 !== 0 || (await count()) <= FRAMES + 1; at++) {
    const away = Math.abs((at % 40) - 20) * STEP_PX;
    await page.mouse.move(from.x - 12 - away, from.y - away / 2);
  }
  await page.mouse.up();
  const times = await page.evaluate(() => (window as unknown as { benchFrames: number[] }).benchFrames);
  return times.slice(1).map((time, i) => time - (times[i] ?? time));
}
