import { tmpdir } from 'node:os';
import type { Page } from 'playwright-core';
import type { CaptureMesh } from '../../nodes/kit/capture.ts';
import type { ToolContext } from '../lib/tool.ts';
import { type Bench, timeMs } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import { bumpyBall, bumpyPinhole, bumpyPoses } from './pages/bumpy-capture.ts';
import type { Weights } from './pages/capture.page.ts';
import { paperViews, paperWeights } from './paper-weights.ts';

const VERTICES = 200_000;
const VIEWS = 50;
const FRAMES = 30;
const SAMPLES = 3;

/** Milliseconds of a frame of a lumigraph at 640 × 480, and what its weights per vertex cost. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let opened: Promise<{ readonly page: Page; readonly close: () => Promise<void> }> | undefined;
  let users = 0;
  const open = async () => {
    const browser = await startBenchBrowser();
    const page = await openPage(browser, root, 'tools/bench/pages/capture.page.ts', tmpdir());
    await call(page, 'open', VERTICES, VIEWS, FRAMES);
    return { page, close: () => browser.close() };
  };
  const frame = async (weights: Weights): Promise<number> => {
    opened ??= open();
    return call<number>((await opened).page, 'frame', weights);
  };
  const of = `${VERTICES / 1000},000 vertices, ${VIEWS} photographs`;
  const measured = (name: string, unit: Bench['unit'], sample: () => Promise<number>): Bench => {
    users++;
    return {
      name,
      unit,
      samples: SAMPLES,
      sample,
      dispose: async () => {
        if (--users === 0) await (await opened)?.close();
      },
    };
  };
  return [
    ...[VERTICES / 4, VERTICES].map(paperLoop),
    measured(`draw a capture, ${of}, weights per pixel`, 'ms', () => frame('pixel')),
    measured(`draw a capture, ${of}, weights per vertex that are there`, 'ms', () => frame('kept')),
    measured(`compute weights, ${of}`, 'ms', () => frame('all')),
    measured(`compute weights, ${of}, window of ${FRAMES} frames`, 'ms', () => frame('window')),
    measured(
      `weights of a window against all, ${of}, ${FRAMES} frames`,
      'ratio',
      async () => (await frame('window')) / (await frame('all')),
    ),
  ];
}

/** The weights of all vertices by the loop of the paper, on one thread. */
function paperLoop(vertexCount: number): Bench {
  let scene: { readonly mesh: CaptureMesh; readonly normals: Int8Array; readonly views: ReturnType<typeof paperViews> } | undefined;
  return {
    name: `compute weights by the paper's loop, ${vertexCount / 1000},000 vertices, ${VIEWS} photographs`,
    unit: 'ms',
    samples: SAMPLES,
    sample: () => {
      if (!scene) {
        const mesh = bumpyBall(vertexCount);
        scene = { mesh, normals: outward(mesh), views: paperViews(mesh, bumpyPinhole, bumpyPoses(VIEWS)) };
      }
      const { mesh, normals, views } = scene;
      return timeMs(() => paperWeights(mesh, normals, views, [2.4, 0.4, 0]));
    },
  };
}

/** The directions of the vertices from the middle of a ball, which are nearly its normals: four signed bytes each. */
function outward({ positions }: CaptureMesh): Int8Array {
  return Int8Array.from({ length: (4 * positions.length) / 3 }, (_, i) => {
    const place = positions.subarray(3 * (i >> 2), 3 * (i >> 2) + 3);
    return Math.round((127 * (place[i & 3] ?? 0)) / Math.hypot(...place));
  });
}
