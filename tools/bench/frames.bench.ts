import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import type { ProjectFiles } from '../../app/contract/contract.ts';
import { compileProject } from '../../app/services/compile-project.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { SECTIONS } from '../examples/gallery-cells.ts';
import { PEGS } from '../examples/gallery-lights.ts';
import { cellFootM, cellMiddleM, MIDDLE_M, RAIL_M, WALL_M } from '../examples/gallery-place.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Standing } from './pages/robots-on-floor.ts';
import type { GalleryPlan } from './pages/three-gallery.page.ts';

const SIZE_PX = [640, 480] as const;
const FRAMES = 5;
/** Samples per row. Few, because a frame may take a second on a CPU. */
const SAMPLES = 9;
/** Number of discarded frames, in which shaders and tables are created. */
const WARM_FRAMES = 10;
/** Number of frames over which garbage is measured: enough to separate it from noise. */
const HEAP_FRAMES = 120;

const ROBOTS_OF_FIRST_LIGHT: readonly Standing[] = [
  { x: -0.32, z: -0.95, turn: 0.35, scale: 1.9 },
  { x: 0.62, z: -0.28, turn: 0.1, scale: 1.1 },
];
const ROBOTS_OF_OCCLUSION: readonly Standing[] = [{ x: 0.3, z: -0.85, turn: 0.2, scale: 2.2 }];

const GALLERY: GalleryPlan = {
  middle: MIDDLE_M,
  wall: WALL_M,
  rail: RAIL_M,
  cells: SECTIONS.flatMap(({ cells, row, column }) => cells.map(({ shows: [kind] }, i) => ({ kind, foot: cellFootM(row, column + i) }))),
  lit: [cellMiddleM(7, 0), cellMiddleM(7, 1), cellMiddleM(7, 2), cellMiddleM(7, 3)],
  pegs: PEGS,
};

/** Edits the project of an example before it is measured. */
type Change = (document: Document) => void;

interface Document {
  readonly graphs: {
    readonly main: { readonly nodes: Record<string, { readonly type: string; muted?: boolean }>; wires: readonly string[] };
  };
}

const asItIs: Change = () => {};
const withoutFilter: Change = ({ graphs: { main } }) => {
  for (const node of Object.values(main.nodes)) if (node.type === 'filter/color-temperature') node.muted = true;
};
/** Removes the image layers from the gallery, so that only its scenes are drawn: the wall, the lamps and the sky. */
const scenesAlone: Change = ({ graphs: { main } }) => {
  main.wires = main.wires.map((wire) => wire.replace('over-blend.layer -> screen-all', 'over-sky.layer -> screen-all'));
};

/**
 * Measures frames of two examples and two templates. Frames that consist of scenes are also compared with the same objects, lights and
 * shadows drawn by three.js alone. The template `filter`, and the masks, trails and blended layers of the gallery, are not compared,
 * because three.js has no counterpart.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const robots = { page: 'three.page.ts', file: 'assets/robot.glb' };
  const gallery = {
    page: 'three-gallery.page.ts',
    file: 'assets/sky.hdr',
    example: 'boards/gallery',
    more: [GALLERY],
    change: scenesAlone,
  };
  const firstLight = { ...robots, example: 'first-light' };
  return [
    time(root, 'first-light'),
    time(root, 'boards/gallery'),
    time(root, 'templates/occlusion'),
    time(root, 'templates/filter'),
    compare(root, 'frame, first-light', { ...firstLight, change: asItIs, more: [ROBOTS_OF_FIRST_LIGHT, true] }),
    // Both draw directly to the output.
    compare(root, 'frame, first-light without its filter', { ...firstLight, change: withoutFilter, more: [ROBOTS_OF_FIRST_LIGHT, false] }),
    compare(root, 'frame, templates/occlusion', {
      ...robots,
      example: 'templates/occlusion',
      more: [ROBOTS_OF_OCCLUSION, false],
      change: asItIs,
    }),
    compare(root, 'frame, scenes of gallery', gallery),
    ...garbage(root, 'scenes of gallery', gallery),
  ];
}

function time(root: string, example: string): Bench {
  let opened: Promise<{ browser: Browser; page: Page }> | undefined;
  const open = async () => {
    const browser = await startBenchBrowser();
    return { browser, page: await openExample(browser, root, example, asItIs) };
  };
  return {
    name: `frame, ${example}`,
    unit: 'ms',
    samples: SAMPLES,
    sample: async () => {
      opened ??= open();
      return call<number>((await opened).page, 'frameMs', FRAMES);
    },
    dispose: async () => (await opened)?.browser.close(),
  };
}

interface Compared {
  readonly example: string;
  readonly change: Change;
  /**
   * The file of the page that draws the same scene with plain three.js, the file of the example that it loads, and its further arguments.
   */
  readonly page: string;
  readonly file: string;
  readonly more: readonly unknown[];
}

interface Pair {
  readonly browser: Browser;
  readonly ours: Page;
  readonly theirs: Page;
}

async function openPair(root: string, { example, change, page, file, more }: Compared): Promise<Pair> {
  const browser = await startBenchBrowser();
  const ours = await openExample(browser, root, example, change);
  const theirs = await openPage(browser, root, `tools/bench/pages/${page}`, join(root, 'examples', example));
  await call(theirs, 'open', file, ...SIZE_PX, ...more);
  for (const each of [ours, theirs]) await call(each, 'frameMs', WARM_FRAMES);
  return { browser, ours, theirs };
}

function compare(root: string, name: string, compared: Compared): Bench {
  let opened: Promise<Pair> | undefined;
  return {
    name: `${name}, against three.js alone`,
    unit: 'ratio',
    samples: SAMPLES,
    sample: async () => {
      opened ??= openPair(root, compared);
      const { ours, theirs } = await opened;
      const sums = { ours: 0, theirs: 0 };
      // Alternately, so that other load of the machine affects both equally.
      for (let i = 0; i < FRAMES; i++) {
        sums.ours += await call<number>(ours, 'frameMs', 1);
        sums.theirs += await call<number>(theirs, 'frameMs', 1);
      }
      return sums.ours / sums.theirs;
    },
    dispose: async () => (await opened)?.browser.close(),
  };
}

/** Two rows: kilobytes of garbage per frame of an example, and of the same scene drawn by three.js alone. */
function garbage(root: string, name: string, compared: Compared): readonly Bench[] {
  let measured: Promise<{ readonly ours: number; readonly theirs: number }> | undefined;
  const measure = async () => {
    const { browser, ours, theirs } = await openPair(root, compared);
    const kilobytes = { ours: await allocated(ours), theirs: await allocated(theirs) };
    await browser.close();
    return kilobytes;
  };
  const row = (whose: string, of: (m: { readonly ours: number; readonly theirs: number }) => number): Bench => ({
    name: `garbage of a frame, ${name}${whose}`,
    unit: 'kB',
    samples: 1,
    sample: async () => {
      measured ??= measure();
      return of(await measured);
    },
  });
  return [row('', ({ ours }) => ours), row(' by three.js alone', ({ theirs }) => theirs)];
}

interface HeapNode {
  readonly selfSize: number;
  readonly children: readonly HeapNode[];
}

/** Kilobytes that a page allocates per frame, including objects that have been collected, by the sampling heap profiler of V8. */
async function allocated(page: Page): Promise<number> {
  const client = await page.context().newCDPSession(page);
  const options = { samplingInterval: 512, includeObjectsCollectedByMajorGC: true, includeObjectsCollectedByMinorGC: true };
  await client.send('HeapProfiler.startSampling', options);
  await call(page, 'frameMs', HEAP_FRAMES);
  const { profile } = await client.send('HeapProfiler.stopSampling');
  const sum = ({ selfSize, children }: HeapNode): number => children.reduce((total, child) => total + sum(child), selfSize);
  return sum(profile.head) / HEAP_FRAMES / 1000;
}

async function openExample(browser: Browser, root: string, example: string, change: Change): Promise<Page> {
  const folder = join(root, 'examples', example);
  const { program } = await compileProject(folder, changed(await readProjectFiles(folder), change), () => ({ sourceMaps: false }));
  if (program === null) throw new Error(`The example ${example} does not compile.`);
  const page = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
  await call(page, 'open', program, '', ...SIZE_PX);
  return page;
}

function changed(files: ProjectFiles, change: Change): ProjectFiles {
  const document = JSON.parse(files.project) as Document;
  change(document);
  return { ...files, project: JSON.stringify(document) };
}
