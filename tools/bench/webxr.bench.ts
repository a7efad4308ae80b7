import { tmpdir } from 'node:os';
import type { Browser, Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { childrenCpuMs } from './cpu-time.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Asked } from './pages/webxr.page.ts';

const ASKED: readonly Asked[] = ['nothing', 'hit test', 'depth, CPU', 'depth, GPU', 'light', 'planes', 'camera picture', 'all'];
const SIZE_PX = [640, 480] as const;
const FRAMES = 5;
const SAMPLES = 9;

/**
 * Measures the cost of each part of WebXR in the emulated device, without Scrim's own work: Figure 22 of "Environment-Aware Rendering and
 * Interaction in Web-Based Augmented Reality" (2023). Counts CPU time if the system reports it, else wall-clock time.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  return ASKED.map((asked) => {
    let opened: Promise<{ readonly browser: Browser; readonly page: Page }> | undefined;
    const open = async () => {
      const browser = await startBenchBrowser();
      const page = await openPage(browser, root, 'tools/bench/pages/webxr.page.ts', tmpdir());
      await call(page, 'open', asked, ...SIZE_PX);
      await call(page, 'frameMs', FRAMES);
      const answers = await call<number>(page, 'answered');
      if (answers > 0 !== (asked !== 'nothing')) throw new Error(`Asked for ${asked}, the device answered ${answers}.`);
      return { browser, page };
    };
    return {
      name: `frame of the emulated phone, asked for ${asked}`,
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => {
        opened ??= open();
        const { page } = await opened;
        const before = childrenCpuMs();
        const wallMs = await call<number>(page, 'frameMs', FRAMES);
        const after = childrenCpuMs();
        return before === null || after === null ? wallMs : (after - before) / FRAMES;
      },
      dispose: async () => (await opened)?.browser.close(),
    };
  });
}
