import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ProjectFiles } from '../../app/contract/contract.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile } from './bench.ts';
import { compiledProgram } from './compiled-program.ts';
import { frameCpuMs, openProgram, SIZE_PX, testImage } from './drawn-program.ts';
import { filteredProject } from './filtered-project.ts';
import { frameTraffic } from './frame-traffic.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Chain, Contender } from './pages/chains.page.ts';
import type { FrameFacts } from './pages/frame-facts.ts';

/** At least seven, measured in turn. */
const SAMPLES = 7;
/** A frame takes about a second where the CPU draws it, so two are enough for ticks of 10 ms. */
const FRAMES = 2;

interface Subject {
  readonly name: string;
  /** The folder of the files that the project shows. */
  readonly folder: string;
  readonly files: ProjectFiles;
  /**
   * The same for the pages without Scrim; null if they cannot draw it. Figure 11 is two layers of objects, of which one is strokes where the
   * shadow of the other falls on the room: neither pmndrs/postprocessing nor three's EffectComposer has a shadow without its receiver, and by
   * hand it would be the node's own shaders once more.
   */
  readonly chain: Chain | null;
}

const CONTENDERS: readonly Contender[] = ['by hand', 'postprocessing', 'EffectComposer'];
const NAMES = ['fused', 'one pass per effect', ...CONTENDERS] as const;
type Name = (typeof NAMES)[number];

/**
 * Milliseconds per frame, passes and targets of graphs over 1280 × 720 pixels that one pass cannot draw: as Scrim exports them, with one pass
 * per effect, in shaders written by hand that round as ours do, in as few passes of pmndrs/postprocessing as it allows, and in three.js'
 * EffectComposer. All are measured in turn, by CPU time where the system has `/proc` (ADR 25).
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-'));
  await writeFile(join(folder, 'photo.png'), testImage());
  const figure = join(root, 'examples', 'sketchy-shadow');
  const figureFiles = await readProjectFiles(figure);
  const subjects: readonly Subject[] = [
    { name: '5 effects with a blur', folder, files: projectFiles(BLURRED), chain: 'blurred' },
    { name: 'a drawing where a mask says so', folder, files: projectFiles(MASKED), chain: 'masked' },
    {
      name: 'figure 11 with a filter',
      folder: figure,
      files: { ...figureFiles, project: filteredProject(figureFiles.project) },
      chain: null,
    },
  ];
  const browser = lazy(startBenchBrowser);
  const close = async () => {
    await (await browser()).close();
    await rm(folder, { recursive: true, force: true });
  };
  return subjects.flatMap((subject, i) => raced(root, browser, subject, i === subjects.length - 1 ? close : null));
}

interface Stage {
  readonly pages: ReadonlyMap<Name, Page>;
  readonly facts: ReadonlyMap<Name, FrameFacts>;
}

function raced(root: string, browser: () => Promise<Browser>, subject: Subject, close: (() => Promise<void>) | null): Bench[] {
  const { name, chain } = subject;
  const stage = lazy(async () => openStage(await browser(), root, subject));
  const timesMs = new Map<Name, number[]>(NAMES.map((contender) => [contender, []]));
  // Both are measured in the same turn, so the load of the machine affects both.
  const ratio = (to: Name): number => {
    const own = timesMs.get('fused') ?? [];
    const ratios = (timesMs.get(to) ?? []).slice(1).map((ms, i) => (own[i + 1] ?? Number.NaN) / ms);
    return quantile(
      ratios.sort((a, b) => a - b),
      0.5,
    );
  };
  const shown = chain === null ? NAMES.slice(0, 2) : NAMES;
  const fact = (what: 'passes' | 'targets', contender: Name, of: (facts: FrameFacts) => number): Bench => ({
    name: `${what}, ${name}, ${contender}`,
    unit: 'count',
    samples: 1,
    sample: async () => of((await stage()).facts.get(contender) ?? { draws: Number.NaN, targets: Number.NaN }),
  });
  const rows: Bench[] = [
    {
      name: `${name} over 720p, fused`,
      unit: 'ms',
      samples: SAMPLES,
      sample: async () => {
        for (const [contender, page] of (await stage()).pages) timesMs.get(contender)?.push(await frameCpuMs(page, FRAMES));
        return timesMs.get('fused')?.at(-1) ?? Number.NaN;
      },
    },
    ...shown.slice(1).map(
      (contender): Bench => ({
        name: `${name} over 720p, fused against ${contender}`,
        unit: 'ratio',
        samples: 1,
        sample: () => ratio(contender),
      }),
    ),
    ...shown.flatMap((contender) => [
      fact('passes', contender, ({ draws }) => draws),
      fact('targets', contender, ({ targets }) => targets),
    ]),
  ];
  const last = rows.pop();
  if (last === undefined) return rows;
  const dispose = async () => {
    for (const page of (await stage()).pages.values()) await page.close();
    await close?.();
  };
  return [...rows, { ...last, dispose }];
}

async function openStage(browser: Browser, root: string, { folder, files, chain }: Subject): Promise<Stage> {
  const pages = new Map<Name, Page>();
  const facts = new Map<Name, FrameFacts>();
  for (const name of ['fused', 'one pass per effect'] as const) {
    const program = await compiledProgram(folder, files, { fuse: name === 'fused' });
    const page = await openProgram(browser, root, folder, program);
    pages.set(name, page);
    // The draws of objects are no passes, so those of figure 11 are counted in its program.
    const { passes, targets } = frameTraffic(program, { widthPx: SIZE_PX[0], heightPx: SIZE_PX[1] });
    facts.set(name, chain === null ? { draws: passes, targets } : await call<FrameFacts>(page, 'facts'));
  }
  if (chain === null) return { pages, facts };
  for (const name of CONTENDERS) {
    const page = await openPage(browser, root, 'tools/bench/pages/chains.page.ts', folder);
    await call(page, 'open', chain, name, 'photo.png', ...SIZE_PX);
    pages.set(name, page);
    facts.set(name, await call<FrameFacts>(page, 'facts'));
  }
  await expectSameImages(pages);
  return { pages, facts };
}

/** Places whose colors are compared. */
const PLACES = Array.from(
  { length: 240 },
  (_, i) => [Math.floor((((i % 20) + 0.5) / 20) * SIZE_PX[0]), 25 + Math.floor(i / 20) * 60] as const,
);

/**
 * The share of places whose color may differ by more than a step: a step before it, a color may have been on the other side of a threshold.
 * The libraries neither round nor clamp between effects, so the vignette darkens brighter colors than 1 where sepia gives them: at 20 of 240
 * places.
 */
const MOST_OTHERS: Readonly<Record<Name, number>> = {
  fused: 0,
  'one pass per effect': 0,
  'by hand': 0.01,
  postprocessing: 0.1,
  EffectComposer: 0.1,
};

/** Throws if a contender does not draw the image that the others draw. */
async function expectSameImages(pages: ReadonlyMap<Name, Page>): Promise<void> {
  let first: number[][] | null = null;
  for (const [name, page] of pages) {
    const colors = await call<number[][]>(page, 'pixelsAt', PLACES);
    first ??= colors;
    const others = colors.filter((color, i) => color.some((value, channel) => Math.abs(value - (first?.[i]?.[channel] ?? 0)) > 1));
    if (others.length / PLACES.length <= MOST_OTHERS[name]) continue;
    throw new Error(`${name} draws other colors at ${others.length} of ${PLACES.length} places, as ${JSON.stringify(others.slice(0, 3))}.`);
  }
}

function lazy<T>(make: () => Promise<T>): () => Promise<T> {
  let made: Promise<T> | undefined;
  return () => {
    made ??= make();
    return made;
  };
}

type Graph = readonly [nodes: Readonly<Record<string, object>>, wires: readonly string[]];

const PHOTO = {
  'photo-a': { type: 'source/image-file', version: 1, params: { file: 'photo' } },
  'screen-a': { type: 'output/screen', version: 1 },
};
const FIVE = ['filter/sepia', 'filter/vignette', 'filter/gaussian-blur', 'filter/grey', 'filter/curves'];

const BLURRED: Graph = [
  { ...PHOTO, ...Object.fromEntries(FIVE.map((type, i) => [`effect${i}-a`, { type, version: 1 }])) },
  [
    ...FIVE.map((_, i) => `${i === 0 ? 'photo' : `effect${i - 1}`}-a.layer -> effect${i}-a.inputImage`),
    'effect4-a.layer -> screen-a.layer',
  ],
];

const MASKED: Graph = [
  {
    ...PHOTO,
    'ink-a': { type: 'filter/difference-of-gaussians', version: 1 },
    'light-a': { type: 'filter/threshold', version: 1 },
    'choose-a': { type: 'operator/choose-by-mask', version: 1 },
    'sepia-a': { type: 'filter/sepia', version: 1 },
  },
  [
    'photo-a.layer -> ink-a.inputImage',
    'photo-a.layer -> light-a.inputImage',
    'photo-a.layer -> choose-a.inside',
    'light-a.layer -> choose-a.mask',
    'ink-a.layer -> choose-a.outside',
    'choose-a.layer -> sepia-a.inputImage',
    'sepia-a.layer -> screen-a.layer',
  ],
];

function projectFiles([nodes, wires]: Graph): ProjectFiles {
  const graphs = { main: { nodes, wires } };
  const assets = { photo: { path: 'photo.png', kind: 'image' } };
  return { project: JSON.stringify({ format: 'scrim-project', version: 1, title: 'Effects', graphs, assets }), layout: null, sources: {} };
}
