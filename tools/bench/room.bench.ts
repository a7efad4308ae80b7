import { rm } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { childrenCpuMs } from './cpu-time.ts';
import { call, startBenchBrowser } from './open-page.ts';
import type { RoomPlan } from './pages/room-plan.ts';
import { findModel, openOurs, openThree, roomFolder } from './room-files.ts';

/**
 * Numbers of models (antique cameras) as in Figures 16 to 21 of the paper, each with its rounds and frames per round. Many cameras take
 * seconds on a CPU, so they get fewer. The first round warms up.
 */
const COUNTS: readonly Size[] = [
  { cameras: 1, rounds: 12, frames: 5 },
  { cameras: 10, rounds: 9, frames: 1 },
  { cameras: 40, rounds: 8, frames: 1 },
  { cameras: 112, rounds: 8, frames: 1 },
];
const PLAN = { widthPx: 640, heightPx: 480, shadowMapPx: 1024, filter: 'pcf' } as const;
/** Number of discarded frames, in which shaders and other resources are created. */
const WARM_FRAMES = 3;

/**
 * Variants that draw the same scene, each on a page of its own. Occlusion uses the room depth as it is measured, as the page of three.js
 * would; filled holes do not depend on the number of models, so they are measured with one.
 */
const WAYS = ['three.js', 'ours', 'ours with occlusion', 'ours without shadow', 'ours with filled holes'] as const;
type Way = (typeof WAYS)[number];

function waysOf({ cameras }: Size): readonly Way[] {
  return WAYS.filter((way) => cameras === 1 || way !== 'ours with filled holes');
}

interface Size {
  readonly cameras: number;
  readonly rounds: number;
  readonly frames: number;
}

/** Milliseconds of a frame: wall-clock time and CPU time. Both are wall-clock time if the system does not report CPU time. */
interface Sample {
  readonly wallMs: number;
  readonly costMs: number;
}

type Times = Readonly<Record<Way, readonly Sample[]>>;

/**
 * Measures what depth occlusion, estimated light and shadows cost when scenes are drawn straight to the screen, compared with three.js
 * alone with the same models, light and shadows: Figures 16 to 21 of "Environment-Aware Rendering and Interaction in Web-Based Augmented
 * Reality" (2023).
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const model = await findModel(root);
  if (model === null) return [];
  return COUNTS.flatMap((size) => benchesOf(root, model, size));
}

function benchesOf(root: string, model: string, size: Size): readonly Bench[] {
  let measured: Promise<Times> | undefined;
  const times = () => {
    measured ??= measureAll(root, model, size);
    return measured;
  };
  const row = (what: string, unit: Bench['unit'], way: Way, to: Way, of: (ms: number, otherMs: number) => number): Bench => {
    let next = 0;
    return {
      name: `frame, ${size.cameras} cameras in a room, ${what}`,
      unit,
      samples: size.rounds - 1,
      sample: async () => {
        const all = await times();
        const i = next++;
        return of(all[way][i]?.costMs ?? Number.NaN, all[to][i]?.costMs ?? Number.NaN);
      },
    };
  };
  const ratio = (ms: number, otherMs: number) => ms / otherMs;
  const againstThree = row('light, shadow and occlusion against three.js alone', 'ratio', 'ours with occlusion', 'three.js', ratio);
  return [
    againstThree,
    {
      name: `${againstThree.name}, least`,
      unit: 'ratio',
      samples: 1,
      sample: async () => {
        const all = await times();
        const ratios = all['ours with occlusion'].map(({ costMs }, i) => costMs / (all['three.js'][i]?.costMs ?? Number.NaN));
        return Math.min(...ratios.slice(1));
      },
    },
    {
      ...row(
        'light, shadow and occlusion, more than three.js alone',
        'ms',
        'ours with occlusion',
        'three.js',
        (ms, otherMs) => ms - otherMs,
      ),
      notes: async () => spread(size, await times()),
    },
    row('occlusion apart', 'ratio', 'ours with occlusion', 'ours', ratio),
    ...(size.cameras === 1
      ? [row('filled holes of room depth apart', 'ratio', 'ours with filled holes', 'ours with occlusion', ratio)]
      : []),
  ];
}

/** Minimum, mean and maximum per frame of each variant, as the paper prints them. */
function spread(size: Size, times: Times): string {
  const lines = waysOf(size).map((way) => {
    const figures = (['wallMs', 'costMs'] as const).map((kind) => {
      const sorted = times[way].map((sample) => sample[kind]).sort((a, b) => a - b);
      const mean = sorted.reduce((sum, ms) => sum + ms, 0) / sorted.length;
      return [sorted[0] ?? 0, mean, sorted.at(-1) ?? 0].map((ms) => ms.toFixed(1)).join(' / ');
    });
    return `  ${way}: ${figures[0]} ms, of computing ${figures[1]} ms\n`;
  });
  return `${size.cameras} cameras, min / mean / max of a frame\n${lines.join('')}`;
}

async function measureAll(root: string, model: string, size: Size): Promise<Times> {
  const { cameras, rounds, frames } = size;
  const folder = await roomFolder(model);
  const browser = await startBenchBrowser();
  try {
    const plan: RoomPlan = { ...PLAN, count: cameras, occlusion: false, shadow: true };
    const open: Readonly<Record<Way, () => Promise<Page>>> = {
      'three.js': () => openThree(browser, root, folder, plan),
      ours: () => openOurs(browser, root, folder, plan),
      'ours with occlusion': () => openOurs(browser, root, folder, { ...plan, occlusion: true, plainDepth: true }),
      'ours without shadow': () => openOurs(browser, root, folder, { ...plan, shadow: false }),
      'ours with filled holes': () => openOurs(browser, root, folder, { ...plan, occlusion: true }),
    };
    const times: Record<Way, Sample[]> = {
      'three.js': [],
      ours: [],
      'ours with occlusion': [],
      'ours without shadow': [],
      'ours with filled holes': [],
    };
    const pages: (readonly [Way, Page])[] = [];
    for (const way of waysOf(size)) pages.push([way, await open[way]()]);
    for (const [, page] of pages) await call(page, 'frameMs', WARM_FRAMES);
    // Alternately, so that other load of the machine affects all equally.
    for (let round = 0; round < rounds; round++) {
      for (const [way, page] of pages) times[way].push(await sampleOf(page, frames));
    }
    return times;
  } finally {
    await browser.close();
    await rm(folder, { recursive: true });
  }
}

async function sampleOf(page: Page, frames: number): Promise<Sample> {
  const before = childrenCpuMs();
  const wallMs = await call<number>(page, 'frameMs', frames);
  const after = childrenCpuMs();
  return { wallMs, costMs: before === null || after === null ? wallMs : (after - before) / frames };
}
