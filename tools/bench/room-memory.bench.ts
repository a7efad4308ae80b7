import { rm } from 'node:fs/promises';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { call, startBenchBrowser } from './open-page.ts';
import { findModel, openOurs, roomFolder } from './room-files.ts';

/** Numbers of models. The device of the paper ran out of memory above 112 (§4). */
const COUNTS = [1, 10, 112, 500];
/** The image is so small that drawing costs little more than its vertices. */
const PLAN = { widthPx: 64, heightPx: 48, shadowMapPx: 256, occlusion: true, shadow: false, filter: 'pcf' } as const;

const WAYS = [
  ['in a room', {}],
  ['by one node of copies', { copies: true }],
] as const;

/**
 * Measures the texture memory on the GPU. It should not depend on how many nodes show the same model, or on the number of copies by an
 * Array node.
 */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const model = await findModel(root);
  if (model === null) return [];
  const cases = WAYS.flatMap(([way, more]) => COUNTS.map((count) => ({ way, more, count })));
  return cases.map(({ way, more, count }) => ({
    name: `texture bytes, ${count} cameras ${way}`,
    unit: 'kB',
    samples: 1,
    sample: async () => {
      const folder = await roomFolder(model);
      const browser = await startBenchBrowser();
      try {
        const page = await openOurs(browser, root, folder, { ...PLAN, ...more, count });
        // Textures are uploaded in the first frame that shows them.
        await call(page, 'frameMs', 1);
        return (await call<number>(page, 'textureBytes')) / 1000;
      } finally {
        await browser.close();
        await rm(folder, { recursive: true });
      }
    },
  }));
}
