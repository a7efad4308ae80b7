import { rm } from 'node:fs/promises';
import type { Browser, Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { childrenCpuMs } from './cpu-time.ts';
import { call, startBenchBrowser } from './open-page.ts';
import type { RoomPlan } from './pages/room-plan.ts';
import { findModel, openOurs, roomFolder } from './room-files.ts';

const SIZES = [256, 1024, 4096, 8192] as const;

/**
 * Table 1 of "Environment-Aware Rendering and Interaction in Web-Based Augmented Reality" (2023): milliseconds per frame on its phone, for
 * each of `SIZES`. The paper has no figures for PCSS.
 */
const PAPER_MS = {
  basic: [1.1, 1.32, 1.37, 1.51],
  pcf: [1.12, 1.42, 1.97, 2.75],
  soft: [1.18, 1.53, 2.08, 3.42],
  vsm: [1.15, 1.67, 3.18, 5.42],
  pcss: null,
} as const;
type Filter = keyof typeof PAPER_MS;
const FILTERS = Object.keys(PAPER_MS) as Filter[];

const PLAN = { widthPx: 640, heightPx: 480, count: 1, occlusion: false, shadow: true } as const;
const WARM_FRAMES = 2;
const FRAMES = 3;
const SAMPLES = 3;

/**
 * Measures frames with a model and its shadow on the floor, for each filter and size of the shadow map: CPU time per frame, printed beside
 * the figures of the paper.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const model = await findModel(root);
  if (model === null) return [];
  const medians = new Map<string, number[]>();
  return FILTERS.flatMap((filter, f) =>
    SIZES.map((shadowMapPx, s): Bench => {
      const name = `frame, shadow ${filter} of ${shadowMapPx} px`;
      let opened: Promise<Opened> | undefined;
      const last = f === FILTERS.length - 1 && s === SIZES.length - 1;
      const samples: number[] = [];
      medians.set(`${filter}/${shadowMapPx}`, samples);
      return {
        name,
        unit: 'ms',
        samples: SAMPLES,
        sample: async () => {
          opened ??= open(root, model, { ...PLAN, shadowMapPx, filter });
          const { page } = await opened;
          const ms = await frameCostMs(page).catch(() => Number.NaN);
          samples.push(ms);
          return ms;
        },
        ...(last && { notes: () => printGrid(medians) }),
        dispose: async () => {
          const { browser, folder } = (await opened) ?? {};
          await browser?.close();
          if (folder !== undefined) await rm(folder, { recursive: true });
        },
      };
    }),
  );
}

interface Opened {
  readonly browser: Browser;
  readonly page: Page;
  readonly folder: string;
}

async function open(root: string, model: string, plan: RoomPlan): Promise<Opened> {
  const folder = await roomFolder(model);
  const browser = await startBenchBrowser();
  const page = await openOurs(browser, root, folder, plan);
  // Where it fails, the samples do, too.
  await call(page, 'frameMs', WARM_FRAMES).catch(() => {});
  return { browser, page, folder };
}

async function frameCostMs(page: Page): Promise<number> {
  const before = childrenCpuMs();
  const wallMs = await call<number>(page, 'frameMs', FRAMES);
  const after = childrenCpuMs();
  return before === null || after === null ? wallMs : (after - before) / FRAMES;
}

/** Prints each time and its ratio to the cheapest one, because figures of a CPU and of a phone's GPU can only be compared as ratios. */
function printGrid(samples: ReadonlyMap<string, readonly number[]>): string {
  const medianOf = (filter: Filter, size: number): number => {
    const [, ...counted] = samples.get(`${filter}/${size}`) ?? [];
    return counted.sort((a, b) => a - b)[Math.floor(counted.length / 2)] ?? Number.NaN;
  };
  const least = medianOf('basic', SIZES[0]);
  const cell = (ms: number, leastMs: number) =>
    Number.isNaN(ms) ? 'graphics lost' : `${ms.toPrecision(3)} (${(ms / leastMs).toFixed(2)}×)`;
  const rows = FILTERS.map((filter) => {
    const cells = SIZES.map((size, i) => {
      const paper = PAPER_MS[filter]?.[i];
      return `${cell(medianOf(filter, size), least)} · ${paper === undefined ? 'none' : cell(paper, PAPER_MS.basic[0])}`;
    });
    return `| ${filter} | ${cells.join(' | ')} |\n`;
  });
  const head = `| filter, ms ours · paper | ${SIZES.map((size) => `${size}²`).join(' | ')} |\n|---|${SIZES.map(() => '---:').join('|')}|\n`;
  return `Shadows by filter and size of the map; in brackets against the cheapest of the same column of figures\n${head}${rows.join('')}`;
}
