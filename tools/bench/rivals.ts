import type { Browser, Page } from 'playwright-core';
import { compileProject } from '../../app/services/compile-project.ts';
import { type Bench, quantile } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';

const SIZE_PX = [640, 480] as const;
/** Maximum number of frames per sample. A sample ends early when its frames have taken `ENOUGH_MS`. */
const FRAMES = 4;
const ENOUGH_MS = 300;

/** Two pages in one browser: one with the reference, one that plays the candidates in turn. */
export interface Rivals {
  /** Milliseconds per frame of both, measured alternately, so that other load of the machine affects both equally. */
  race(project: object): Promise<{ readonly ours: number; readonly base: number }>;
  /** Called by each finished row. The last one closes the browser. */
  leave(): Promise<void>;
}

export interface RivalsOptions {
  readonly root: string;
  /** Absolute path of the folder with the assets. */
  readonly folder: string;
  readonly base: object;
  /** Shaders of the projects, by file name. */
  readonly shaders?: Readonly<Record<string, string>>;
  /** Number of rows that share the two pages. Each calls `leave` once. */
  readonly rows: number;
}

export function createRivals({ root, folder, base, shaders = {}, rows }: RivalsOptions): Rivals {
  let opened: Promise<{ readonly browser: Browser; readonly ours: Page; readonly base: Page }> | undefined;
  let shown: object = base;
  let left = rows;
  const compiled = async (project: object) => {
    const { program, diagnostics } = await compileProject(
      folder,
      { project: JSON.stringify(project), layout: null, sources: { ...shaders } },
      () => ({ sourceMaps: false }),
    );
    if (program === null) throw new Error(`What is to be measured does not compile: ${JSON.stringify(diagnostics)}`);
    return program;
  };
  const open = async () => {
    const browser = await startBenchBrowser();
    const program = await compiled(base);
    const page = async () => {
      const made = await openPage(browser, root, 'tools/bench/pages/scrim.page.ts', folder);
      await call(made, 'open', program, '', ...SIZE_PX);
      return made;
    };
    return { browser, ours: await page(), base: await page() };
  };
  return {
    race: async (project) => {
      opened ??= open();
      const pages = await opened;
      if (shown !== project) await call(pages.ours, 'show', await compiled(project));
      shown = project;
      const sums = { ours: 0, base: 0 };
      let frames = 0;
      for (; frames < FRAMES && sums.ours < ENOUGH_MS; frames++) {
        sums.ours += await call<number>(pages.ours, 'frameMs', 1);
        sums.base += await call<number>(pages.base, 'frameMs', 1);
      }
      return { ours: sums.ours / frames, base: sums.base / frames };
    },
    leave: async () => {
      left--;
      if (left === 0) await (await opened)?.browser.close();
    },
  };
}

export interface RacedRows {
  readonly project: object;
  /** Name and formula of the ratio to the reference. */
  readonly ratio: { readonly name: string; readonly of: (raced: { readonly ours: number; readonly base: number }) => number };
  /** Name of the row with milliseconds per frame. */
  readonly frame: string;
}

/** Few samples, because there are many rows, and a single core may draw all of them. */
const SAMPLES = 5;

/** Two rows from one measurement: the ratio to the reference, and the milliseconds per frame. */
export function racedBenches(rivals: Rivals, { project, ratio, frame }: RacedRows): readonly Bench[] {
  const timesMs: number[] = [];
  const dispose = () => rivals.leave();
  return [
    {
      name: ratio.name,
      unit: 'ratio',
      samples: SAMPLES,
      sample: async () => {
        const raced = await rivals.race(project);
        timesMs.push(raced.ours);
        return ratio.of(raced);
      },
      dispose,
    },
    {
      name: frame,
      unit: 'ms',
      samples: 1,
      sample: () =>
        quantile(
          timesMs.slice(1).sort((a, b) => a - b),
          0.5,
        ),
      dispose,
    },
  ];
}
