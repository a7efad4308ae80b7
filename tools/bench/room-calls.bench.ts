import { rm } from 'node:fs/promises';
import type { Browser } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, startBenchBrowser } from './open-page.ts';
import type { GlCalls } from './pages/gl-calls.ts';
import type { RoomPlan } from './pages/room-plan.ts';
import { findModel, openOurs, openThree, roomFolder } from './room-files.ts';

const COUNTS = [1, 10, 40, 112];
const PLAN = {
  widthPx: 64,
  heightPx: 48,
  shadowMapPx: 256,
  filter: 'pcf',
  occlusion: true,
  shadow: true,
  plainDepth: true,
  counted: true,
} as const;
/** Number of discarded frames, in which shaders and other resources are created. */
const WARM_FRAMES = 3;

const FIGURES = [
  ['draw calls', ({ draws }) => draws],
  ['state changes', ({ stateChanges }) => stateChanges],
  ['program switches', ({ programSwitches }) => programSwitches],
] as const satisfies readonly (readonly [string, (calls: GlCalls) => number])[];

/** Calls of a frame. */
export interface CallsOfBoth {
  readonly ours: GlCalls;
  readonly three: GlCalls;
}

/**
 * Calls of WebGL in a frame of antique cameras with light, shadow and occlusion, and in one that plain three.js draws of the same: the
 * figures do not depend on the machine.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const model = await findModel(root);
  if (model === null) return [];
  return COUNTS.flatMap((cameras) => {
    let counted: Promise<CallsOfBoth> | undefined;
    const count = async (): Promise<CallsOfBoth> => {
      const browser = await startBenchBrowser();
      try {
        return await callsOfBoth(browser, root, model, cameras);
      } finally {
        await browser.close();
      }
    };
    return FIGURES.flatMap(([figure, of]) =>
      (['ours', 'three'] as const).map(
        (whose): Bench => ({
          name: `${figure}, ${cameras} cameras in a room${whose === 'three' ? ', three.js alone' : ''}`,
          unit: 'count',
          samples: 1,
          sample: async () => {
            counted ??= count();
            return of((await counted)[whose]);
          },
        }),
      ),
    );
  });
}

/** Counts the calls of a frame in both. */
export async function callsOfBoth(browser: Browser, root: string, model: string, cameras: number): Promise<CallsOfBoth> {
  const folder = await roomFolder(model);
  const plan: RoomPlan = { ...PLAN, count: cameras };
  try {
    const pages = { ours: await openOurs(browser, root, folder, plan), three: await openThree(browser, root, folder, plan) };
    const calls: Partial<Record<keyof CallsOfBoth, GlCalls>> = {};
    for (const whose of ['ours', 'three'] as const) {
      await call(pages[whose], 'frameMs', WARM_FRAMES);
      calls[whose] = await call<GlCalls>(pages[whose], 'glCalls');
      await pages[whose].close();
    }
    return calls as CallsOfBoth;
  } finally {
    await rm(folder, { recursive: true });
  }
}
