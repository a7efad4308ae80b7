import type { Page } from 'playwright-core';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, openPage, startBenchBrowser } from './open-page.ts';
import type { Place, Surface } from './pages/discard.page.ts';

const SAMPLES = 9;
const FRAMES: Readonly<Record<Surface, number>> = { simple: 20, heavy: 6 };
const HIDDEN = [0, 0.5, 1];

/**
 * What it costs to discard what the room hides at the end of a shader, where derivatives are defined, against an earlier test: an object
 * that covers the view, in one run (ADR 26).
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  let page: Promise<Page> | undefined;
  const open = () => {
    page ??= startBenchBrowser().then((browser) => openPage(browser, root, 'tools/bench/pages/discard.page.ts', root));
    return page;
  };
  const cases = (['simple', 'heavy'] as const).flatMap((surface) => HIDDEN.map((hidden) => ({ surface, hidden })));
  return cases.flatMap(({ surface, hidden }, index) => {
    const measured: Promise<Record<Place, number>>[] = [];
    const sampleAt = async (i: number) => {
      measured[i] ??= call<Record<Place, number>>(await open(), 'measure', surface, hidden, FRAMES[surface]);
      return measured[i];
    };
    const others = surface === 'simple' ? (['first'] as const) : (['before light', 'first'] as const);
    return others.map((place, row): Bench => {
      let next = 0;
      return {
        name: `frame, ${surface} object ${hidden * 100} % hidden, discarded last against ${place}`,
        unit: 'ratio',
        samples: SAMPLES,
        sample: async () => {
          const times = await sampleAt(next++);
          return times.last / times[place];
        },
        notes: async () => {
          const times = await sampleAt(next - 1);
          return `${surface}, ${hidden * 100} % hidden: ${Object.entries(times)
            .map(([at, ms]) => `${at} ${ms.toFixed(2)} ms`)
            .join(', ')}`;
        },
        dispose: async () => {
          if (index === cases.length - 1 && row === others.length - 1) await (await page)?.context().browser()?.close();
        },
      };
    });
  });
}
