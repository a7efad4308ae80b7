import { tmpdir } from 'node:os';
import type { Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';

const SIZE_PX = [640, 360] as const;
const COUNTS = [100_000, 500_000] as const;
const SAMPLES = 3;

/** Milliseconds to draw and to sort splats of degree 3 on the walls of a room, and the bytes of their file in a page. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  return COUNTS.flatMap((count) => {
    const of = `${count / 1000},000 splats`;
    return [
      measured(root, count, false, `draw ${of} at 640 × 360`, 'drawMs'),
      measured(root, count, true, `draw ${of} with depth at 640 × 360`, 'drawMs'),
      measured(root, count, false, `sort ${of}`, 'sortMs'),
    ];
  });
}

function measured(root: string, count: number, readsDepth: boolean, name: string, quantity: 'drawMs' | 'sortMs'): Bench {
  let opened: Promise<{ readonly page: Page; readonly bytes: number; readonly close: () => Promise<void> }> | undefined;
  const open = async () => {
    const browser = await startBenchBrowser();
    const page = await openPage(browser, root, 'tools/bench/pages/splats.page.ts', tmpdir());
    return { page, bytes: await call<number>(page, 'open', count, ...SIZE_PX, readsDepth), close: () => browser.close() };
  };
  return {
    name,
    unit: 'ms',
    samples: SAMPLES,
    sample: async () => {
      opened ??= open();
      return call<number>((await opened).page, quantity);
    },
    ...(quantity === 'sortMs' && {
      notes: async () =>
        `${name}: ${(((await opened)?.bytes ?? 0) / 1e6).toFixed(1)} MB in a page, ${((248 * count) / 1e6).toFixed(1)} MB as PLY.`,
    }),
    dispose: async () => (await opened)?.close(),
  };
}
