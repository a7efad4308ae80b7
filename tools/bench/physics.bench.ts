import { type Bench, quantile, timeMs } from './bench.ts';
import { holdsOnDegrees, openHeap, stackSinksMm } from './physics/box-scenes.ts';
import { createDenseGrid, createSparseGrid, type MeasuredGrid, roomFrame } from './physics/grids.ts';
import { type MeasuredBodies, openBodies } from './physics/main-thread.ts';
import { type BoxWorld, type RivalEngine, rivalEngines } from './physics/rival-engines.ts';

const DEPTHS = [
  [160, 90],
  [640, 480],
] as const;
const EDGE_M = 0.05;
const SPEED = 0.2;
/** The camera turns from frame to frame and sees the whole room. */
const TURN_RAD = 0.1;
const TURNS = 63;
const BODY_COUNTS = [10, 100, 500, 1000] as const;
const FRAMES = 30;

/** Physics: steps of a heap in three engines, voxels against a dense grid, and what a frame costs the page. */
export async function benches(): Promise<readonly Bench[]> {
  const engines = await rivalEngines();
  return [...engines.map((engine, i) => heapBench(engine, i === engines.length - 1 ? engines : [])), ...voxelBenches(), ...pageBenches()];
}

function heapBench(engine: RivalEngine, all: readonly RivalEngine[]): Bench {
  let world: BoxWorld | undefined;
  const stepsMs: number[] = [];
  return {
    name: `physics step, heap of 100 boxes, ${engine.name}`,
    unit: 'ms',
    sample: async () => {
      world ??= openHeap(engine);
      const opened = world;
      const spentMs = await timeMs(() => opened.step());
      stepsMs.push(spentMs);
      return spentMs;
    },
    ...(all.length > 0 && { notes: () => outcomes(all) }),
  };
}

/** What becomes of a stack and of a box on a slope, as a Markdown table. */
function outcomes(engines: readonly RivalEngine[]): string {
  const rows = engines.map((engine) => {
    const sinksMm = stackSinksMm(engine);
    return `| ${engine.name} | ${sinksMm > 100 ? 'falls' : `${sinksMm.toFixed(1)} mm too low`} | ${holdsOnDegrees(engine)}° |\n`;
  });
  return `\n| engine | ten boxes after 10 s | holds on a slope, friction 0.5 |\n| --- | ---: | ---: |\n${rows.join('')}`;
}

function voxelBenches(): Bench[] {
  return DEPTHS.flatMap(([widthPx, heightPx]) => {
    const frames = Array.from({ length: TURNS }, (_, i) => roomFrame(widthPx, heightPx, TURN_RAD * i));
    const grid = createSparseGrid(EDGE_M, SPEED);
    const dense = createDenseGrid(EDGE_M, SPEED);
    let at = 0;
    const turn = async (to: MeasuredGrid) => {
      const frame = frames[at++ % TURNS];
      return frame ? await timeMs(() => to.update(frame)) : 0;
    };
    const seeAll = async () => {
      for (let i = at; i < TURNS; i++) await turn(grid);
    };
    const depth = `depth of ${widthPx}×${heightPx}`;
    return [
      {
        name: `voxel update, ${depth}`,
        unit: 'ms',
        sample: async () => {
          await seeAll();
          return await turn(grid);
        },
      },
      { name: `voxel update, ${depth}, dense grid`, unit: 'ms', sample: () => turn(dense) },
      {
        name: `voxels touched by a dense grid, ${depth}, against ours`,
        unit: 'ratio',
        sample: async () => {
          await seeAll();
          await turn(grid);
          return dense.touched / grid.touched;
        },
      },
    ];
  });
}

function pageBenches(): Bench[] {
  let emptyMs = 0;
  return [0, ...BODY_COUNTS].map((count) => {
    let opened: MeasuredBodies | undefined;
    const frameMs = () => {
      opened ??= openBodies(count);
      const measured = opened;
      const times = Array.from({ length: FRAMES }, () => measured.frameMs()).sort((a, b) => a - b);
      return quantile(times, 0.5);
    };
    return {
      name: count === 0 ? 'page time of a frame with an empty physics world' : `page time of a frame more with ${count} bodies`,
      unit: 'ms',
      sample: () => {
        const spentMs = frameMs();
        if (count === 0) emptyMs = spentMs;
        return count === 0 ? spentMs : spentMs - emptyMs;
      },
    } satisfies Bench;
  });
}
