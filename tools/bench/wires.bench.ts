import type { Browser, Page } from 'playwright-core';
import { centerOf } from '../lib/center-of.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { type GraphPage, openGraph, zoomToNode } from './graph-page.ts';
import { hubGraph } from './grid-graph.ts';
import { startBenchBrowser } from './open-page.ts';

const MOVES = 60;
const WIRES = [100, 500, 1000];

/**
 * The search for the wire under the pointer while a wire is dragged, per move of the pointer: time of the window's own listeners for a
 * synthetic event. All wires begin in view, at the port from which the dragged one comes, and their bounds cover the pointer.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let browser: Browser | undefined;
  return WIRES.map((wires, index): Bench => {
    let opened: Promise<GraphPage> | undefined;
    let moves: number[] = [];
    const open = async () => {
      browser ??= await startBenchBrowser();
      const graph = await openGraph(root, browser, hubGraph(wires));
      await holdWire(graph.page, wires);
      return graph;
    };
    return {
      name: `canvas, move of a dragged wire among ${wires.toLocaleString('en')} wires`,
      unit: 'ms',
      samples: MOVES,
      sample: async () => {
        opened ??= open();
        const { page } = await opened;
        if (moves.length === 0) moves = await timeMoves(page);
        return moves.pop() ?? Number.NaN;
      },
      dispose: async () => {
        await (await opened)?.close();
        if (index === WIRES.length - 1) await browser?.close();
      },
    };
  });
}

/** Drags a wire from the port of the first node, and keeps it in hand. */
async function holdWire(page: Page, wires: number): Promise<void> {
  await zoomToNode(page, 'node-a0');
  const port = await centerOf(page.locator('.react-flow__handle.source[data-nodeid="node-a0"]'));
  await page.mouse.move(port.x, port.y);
  await page.mouse.down();
  await page.mouse.move(port.x + 100, port.y - 40, { steps: 5 });
  await page.locator('.wire-in-hand').waitFor({ state: 'attached' });
  await page.waitForFunction((count) => document.querySelectorAll('.react-flow__edge-path').length >= count, wires);
}

/** Milliseconds per move of the pointer around a place among the wires. */
function timeMoves(page: Page): Promise<number[]> {
  return page.evaluate((count) => {
    const box = document.querySelector('.canvas')?.getBoundingClientRect() ?? new DOMRect();
    return Array.from({ length: count }, (_, i) => {
      const [clientX, clientY] = [box.x + box.width * 0.8 + (i % 9) * 4, box.y + box.height * (0.4 + 0.02 * (i % 11))];
      const startMs = performance.now();
      window.dispatchEvent(new MouseEvent('mousemove', { clientX, clientY }));
      return performance.now() - startMs;
    });
  }, MOVES);
}
