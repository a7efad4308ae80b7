import { execFile } from 'node:child_process';
import { access, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';
import type { Browser } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, quantile } from './bench.ts';
import { machineLoad } from './machine-load.ts';
import { startBenchBrowser } from './open-page.ts';
import { visitSlowly } from './slow-visit.ts';
import { hostFolder, type StaticHost } from './static-host.ts';

const SAMPLES = 5;
/** Factors by which the processor is slowed down: as it is, and as a phone's. */
const SLOWNESS = [1, 4] as const;
const CAPTURE = '../shared/data/captures/icl-livingroom';
/** Where one of the cameras is at the first eye of the page. */
const POSITION_M = [-0.35, 0.68, 2.62];

/** When parts of a visit were over, milliseconds since the start of the navigation. */
interface Visit {
  /** The whole script has arrived. */
  readonly script: number;
  /** The first frame whose pixels show a photograph was drawn, without the poster over it, the GPU's work included. */
  readonly photograph: number;
  /** What had arrived by then, in bytes, without the headers. */
  readonly bytes: number;
}

const run = promisify(execFile);

/**
 * From the moment at which the script of the page of a captured living room has arrived until the first frame that shows a photograph, over a
 * slow network. Each visit is without a cache.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const source = resolve(root, CAPTURE);
  try {
    await access(source);
  } catch {
    console.error(`The first photograph of a captured place is not measured: ${CAPTURE} is missing.`);
    return [];
  }
  let opened: Promise<Stage> | undefined;
  const visits = new Map<number, Visit[]>(SLOWNESS.map((slowness) => [slowness, []]));
  const take = async (slowness: number): Promise<Visit> => {
    opened ??= openStage(root, source);
    const { browser, host } = await opened;
    const seen = await visitSlowly<Visit>(browser, host.url, slowness, watchPixels);
    visits.get(slowness)?.push(seen);
    return seen;
  };
  const rows = SLOWNESS.flatMap((slowness): Bench[] => {
    const of = slowness === 1 ? 'living room' : `living room, processor ${slowness} times slower`;
    return [
      {
        name: `from script to first photograph over 1.6 Mbit/s, ${of}`,
        unit: 'ms',
        samples: SAMPLES,
        sample: async () => {
          const { script, photograph } = await take(slowness);
          return photograph - script;
        },
      },
      {
        name: `from navigation to first photograph over 1.6 Mbit/s, ${of}`,
        unit: 'ms',
        samples: 1,
        // The first visit is a warm-up.
        sample: () => median((visits.get(slowness) ?? []).slice(1).map(({ photograph }) => photograph)),
      },
    ];
  });
  return [
    ...rows,
    {
      name: 'arrived before the first photograph, living room',
      unit: 'kB',
      samples: 1,
      sample: () => median((visits.get(1) ?? []).map(({ bytes }) => bytes / 1000)),
    },
    { ...machineLoad('first photograph'), dispose: async () => (await opened)?.close() },
  ];
}

function median(values: readonly number[]): number {
  return quantile(
    [...values].sort((a, b) => a - b),
    0.5,
  );
}

interface Stage {
  readonly browser: Browser;
  readonly host: StaticHost;
  close(): Promise<void>;
}

/** Imports the capture, shows it and exports the page, all by the command line. */
async function openStage(root: string, source: string): Promise<Stage> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-photograph-'));
  const scrim = (...args: readonly string[]) => run(process.execPath, [join(root, 'bin/scrim.mjs'), ...args], { cwd: base });
  await scrim('new', 'room');
  await scrim('import', 'capture', source, '--project', 'room');
  const file = join(base, 'room/project.scrim.json');
  const project = JSON.parse(await readFile(file, 'utf8')) as { graphs: object; readonly assets: object };
  const [asset] = Object.keys(project.assets);
  const nodes = {
    'place-0000': { type: 'source/capture', version: 2, params: { file: asset, positionM: POSITION_M } },
    'screen-0000': { type: 'output/screen', version: 1 },
  };
  project.graphs = { main: { nodes, wires: ['place-0000.layer -> screen-0000.layer'] } };
  await writeFile(file, JSON.stringify(project));
  await scrim('export', 'room', '--out', 'site');
  const browser = await startBenchBrowser();
  const host = await hostFolder(join(base, 'site'));
  return {
    browser,
    host,
    close: async () => {
      await browser.close();
      await host.close();
      await rm(base, { recursive: true, force: true });
    },
  };
}

/** Page code: finds out when the canvas, without the poster over it, first shows a photograph: at least a quarter is drawn, in many colors. */
function watchPixels(): void {
  let drawn: WebGL2RenderingContext | null = null;
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['drawArrays', 'drawElements'] as const) {
    const own = prototype[name] as (...args: number[]) => void;
    Object.assign(prototype, {
      [name](this: WebGL2RenderingContext, ...args: number[]) {
        own.apply(this, args);
        if (this.getParameter(this.DRAW_FRAMEBUFFER_BINDING) === null && this.canvas instanceof HTMLCanvasElement) drawn = this;
      },
    });
  }
  const showsPhotograph = (gl: WebGL2RenderingContext): boolean => {
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    const pixels = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const colors = new Set<number>();
    let covered = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      const [red = 0, green = 0, blue = 0] = pixels.subarray(i, i + 3);
      if (red + green + blue > 60) covered++;
      colors.add(((red >> 3) << 10) | ((green >> 3) << 5) | (blue >> 3));
    }
    return covered > (width * height) / 4 && colors.size > 200;
  };
  const bytesOf = (entries: PerformanceEntryList): number =>
    (entries as PerformanceResourceTiming[]).reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0);
  const own = globalThis.requestAnimationFrame.bind(globalThis);
  const seen = new Promise((resolve) => {
    const look = (): void => {
      const gl = drawn;
      drawn = null;
      const poster = document.querySelector('img.poster');
      const isCovered = poster?.className === 'poster';
      if (gl === null || isCovered || !showsPhotograph(gl)) return;
      const entries = performance.getEntriesByType('resource') as PerformanceResourceTiming[];
      const script = entries.find(({ name }) => /\/page-[^/]*\.js$/.test(name))?.responseEnd ?? Number.NaN;
      const bytes = bytesOf([...performance.getEntriesByType('navigation'), ...entries]);
      resolve({ script, photograph: performance.now(), bytes });
    };
    // Within the same task as the drawing, whose pixels are gone after it.
    globalThis.requestAnimationFrame = (callback) =>
      own((timeMs) => {
        callback(timeMs);
        look();
      });
  });
  Object.assign(globalThis, { seen });
}
