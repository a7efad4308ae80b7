import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import type { Page } from 'playwright-core';
import { packDepthFiles } from '../../app/services/pack-depth.ts';
import type { CaptureView } from '../../nodes/kit/capture.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { machineLoad } from './machine-load.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import { bumpyBall, bumpyLens, bumpyPoses } from './pages/bumpy-capture.ts';
import type { GrowthCase, GrowthMethod } from './pages/capture-growth.page.ts';

const SAMPLES = 3;
/** As `PHOTO_PX` of the page. */
const PHOTO_PX = 256;

/** The case that the others are compared with. Each of them differs in one thing. */
const BASE: Growth = { viewCount: 18, triangles: 60_000, widthPx: 640, heightPx: 480, method: 'lumigraph' };

const METHODS: Readonly<Record<GrowthMethod, string>> = {
  plain: 'plain',
  nearest: 'nearest',
  lumigraph: 'lumigraph',
  windowed: 'lumigraph with weights per vertex',
  'depth-meshes': 'depth meshes',
};

const CASES: readonly (readonly [of: string, differs: Partial<Growth>])[] = [
  ['8 photographs', { viewCount: 8 }],
  ['50 photographs', { viewCount: 50 }],
  ['15,000 triangles', { triangles: 15_000 }],
  ['200,000 triangles', { triangles: 200_000 }],
  ['320 × 240 pixels', { widthPx: 320, heightPx: 240 }],
  ['1,280 × 960 pixels', { widthPx: 1280, heightPx: 960 }],
  ...(['plain', 'nearest', 'windowed', 'depth-meshes'] as const).map((method) => [METHODS[method], { method }] as const),
];

interface Growth extends Pick<GrowthCase, 'viewCount' | 'widthPx' | 'heightPx' | 'method'> {
  readonly triangles: number;
}

interface Opened {
  readonly page: Page;
  readonly depthViews: readonly CaptureView[];
  close(): Promise<void>;
}

/**
 * How the time of a frame of a capture grows with its photographs, its triangles, the pixels of the image and the method. A frame of each case
 * is drawn in turn, and those of a round are compared with the base case of the same round.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<Opened> | undefined;
  const rounds: Promise<readonly number[]>[] = [];
  const frame = async ({ triangles, ...of }: Growth): Promise<number> => {
    opened ??= openCaptures(root);
    const { page, depthViews } = await opened;
    const wanted: GrowthCase = {
      ...of,
      vertexCount: verticesOf(triangles),
      depthViews: of.method === 'depth-meshes' ? depthViews : null,
    };
    return call<number>(page, 'frame', wanted);
  };
  const drawRound = async (): Promise<readonly number[]> => {
    const frames: number[] = [];
    for (const [, differs] of [['', {}] as const, ...CASES]) frames.push(await frame({ ...BASE, ...differs }));
    return frames;
  };
  const base = '18 photographs, 60,000 triangles, 640 × 480 pixels, lumigraph';
  const row = (name: string, unit: Bench['unit'], of: (frames: readonly number[]) => number | undefined): Bench => {
    let taken = 0;
    const sample = async (): Promise<number> => {
      const round = rounds[taken] ?? drawRound();
      rounds[taken++] = round;
      return of(await round) ?? Number.NaN;
    };
    return { name, unit, samples: SAMPLES, sample };
  };
  return [
    row(`draw a capture, ${base}`, 'ms', ([ms]) => ms),
    ...CASES.map(([of], i) =>
      row(`draw a capture, ${of} against ${base}`, 'ratio', (ms) => (ms[i + 1] ?? Number.NaN) / (ms[0] ?? Number.NaN)),
    ),
    { ...machineLoad('growth of a capture'), dispose: async () => (await opened)?.close() },
  ];
}

/** The vertices of a ball with about so many triangles. */
function verticesOf(triangles: number): number {
  return triangles / 2;
}

async function openCaptures(root: string): Promise<Opened> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-bench-growth-'));
  const mesh = bumpyBall(verticesOf(BASE.triangles));
  const lens = bumpyLens(PHOTO_PX);
  const depthViews: CaptureView[] = [];
  const poses = bumpyPoses(BASE.viewCount);
  for (const [index, worldFromCamera] of poses.entries()) {
    const { files, members } = packDepthFiles(null, mesh, null, lens, worldFromCamera, index, poses.length);
    for (const [file, bytes] of files) {
      await mkdir(dirname(join(folder, file)), { recursive: true });
      await writeFile(join(folder, file), bytes);
    }
    depthViews.push({ file: `${index}.png`, ...lens, worldFromCamera, ...members });
  }
  const browser = await startBenchBrowser();
  const page = await openPage(browser, root, 'tools/bench/pages/capture-growth.page.ts', folder);
  return {
    page,
    depthViews,
    close: async () => {
      await browser.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}
