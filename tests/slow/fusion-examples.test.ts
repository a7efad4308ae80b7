import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import type { RenderJob } from '../../app/cli/render/render.page.ts';
import { firstPlayed } from '../../app/cli/render/render-frames.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import { DECODER_FILES_FOLDER } from '../../export/gltf/decoders.ts';
import type { Program } from '../../export/program/program.ts';
import { compiledProgram } from '../../tools/bench/compiled-program.ts';
import { exampleNames } from '../../tools/lib/example-names.ts';
import type { Difference } from '../browser/fusion-difference.ts';
import { useModule } from '../support/browser.ts';

const ROOT = resolve(import.meta.dirname, '../..');
/**
 * Powers of two: at other sizes the middle of a pixel is not an exact number, so that a pass that reads a texture gets a trace of the next
 * pixel, and 2 of 10,000 colors halfway between two steps become the other one. A fused pass reads no texture there.
 */
const SIZE = { widthPx: 512, heightPx: 256 };
const LAST_FRAME = 2;
/** The options of an export that change passes. */
const PAGE = { fuse: true, fold: true };

const page = useModule('tests/slow/fusion-examples.page.ts', {
  mounts: { '/examples/': join(ROOT, 'examples'), '/decoders/': join(ROOT, DECODER_FILES_FOLDER) },
});

/** A render over a recorded session. */
function renderOf(name: string, program: Program): RenderJob {
  return {
    ...{ program, ...SIZE, subject: { kind: 'screen' }, session: { kind: 'recorded', url: 'examples/sessions/studio/' } },
    ...{ assetBaseUrl: `examples/${name}/`, decodersBaseUrl: 'decoders/' },
  };
}

const names = await exampleNames(ROOT);

test.each(names)('%s looks the same with passes of its own as fused and folded, as a page draws it', async (name) => {
  const folder = join(ROOT, 'examples', name);
  const files = await readProjectFiles(folder);
  const [separate, fused] = [await compiledProgram(folder, files), await compiledProgram(folder, files, PAGE)];
  // Equal operations draw equal images.
  if (JSON.stringify(fused.operations) === JSON.stringify(separate.operations)) return;
  const [before, after] = [renderOf(name, separate), renderOf(name, fused)];
  const first = Math.min(...[before, after].map((job) => firstPlayed({ first: LAST_FRAME, job })));
  const { channels, differing, most } = await page.call<Difference>('compare', before, after, first, LAST_FRAME);
  expect(channels).toBe(4 * SIZE.widthPx * SIZE.heightPx);
  expect(most).toBeLessThanOrEqual(1);
  expect(differing / channels).toBeLessThan(1e-4);
});

test('some examples have fused passes', async () => {
  const folders = names.map((name) => join(ROOT, 'examples', name));
  const fused = await Promise.all(folders.map(async (folder) => compiledProgram(folder, await readProjectFiles(folder), PAGE)));
  expect(fused.filter(({ operations }) => operations.some((one) => one.kind === 'pass' && one.nodes)).length).toBeGreaterThan(5);
});
