import { join, resolve } from 'node:path';
import { expect, test } from '@jest/globals';
import { renderFrames } from '../../app/cli/render/render-frames.ts';
import { findRenderSession } from '../../app/cli/render/render-session.ts';
import { installationAt } from '../../app/services/installation.ts';
import { readProjectFiles } from '../../app/services/project-files.ts';
import type { Program } from '../../export/program/program.ts';
import { compiledProgram } from '../../tools/bench/compiled-program.ts';
import { exampleNames } from '../../tools/lib/example-names.ts';

const ROOT = resolve(import.meta.dirname, '../..');
const INSTALLATION = installationAt(ROOT, '0.0.0');
/**
 * Powers of two: at other sizes the middle of a pixel is not an exact number, so that a pass that reads a texture gets a trace of the next
 * pixel, and 2 of 10,000 colors halfway between two steps become the other one. A fused pass reads no texture there.
 */
const SIZE = { widthPx: 512, heightPx: 256 };
const LAST_FRAME = 2;
/** The options of an export that change passes. */
const PAGE = { fuse: true, fold: true };

/** The last frame over a recorded session. */
async function drawn(folder: string, program: Program): Promise<Uint8Array> {
  const { output: session } = await findRenderSession(null, folder, INSTALLATION, SIZE);
  if (!session) throw new Error('There is no session.');
  let image: Uint8Array | null = null;
  const diagnostics = await renderFrames({
    ...session,
    first: LAST_FRAME,
    last: LAST_FRAME,
    root: ROOT,
    projectRoot: folder,
    job: { program, session: session.session, ...SIZE, subject: { kind: 'screen' } },
    sourceOf: () => undefined,
    onImage: async (_, __, bytes) => {
      image = Uint8Array.from(bytes);
    },
    say: () => {},
  });
  if (image === null) throw new Error(`${folder} is not drawn: ${JSON.stringify(diagnostics)}`);
  return image;
}

const names = await exampleNames(ROOT);

test.each(names)('%s looks the same with passes of its own as fused and folded, as a page draws it', async (name) => {
  const folder = join(ROOT, 'examples', name);
  const files = await readProjectFiles(folder);
  const [separate, fused] = [await compiledProgram(folder, files), await compiledProgram(folder, files, PAGE)];
  // Equal operations draw equal images.
  if (JSON.stringify(fused.operations) === JSON.stringify(separate.operations)) return;
  const [before, after] = [await drawn(folder, separate), await drawn(folder, fused)];
  expect(after.length).toBe(before.length);
  let differing = 0;
  let most = 0;
  for (let i = 0; i < before.length; i++) {
    const difference = Math.abs((before[i] ?? 0) - (after[i] ?? 0));
    if (difference > 0) differing++;
    most = Math.max(most, difference);
  }
  expect(most).toBeLessThanOrEqual(1);
  expect(differing / before.length).toBeLessThan(1e-4);
});

test('some examples have fused passes', async () => {
  const folders = names.map((name) => join(ROOT, 'examples', name));
  const fused = await Promise.all(folders.map(async (folder) => compiledProgram(folder, await readProjectFiles(folder), PAGE)));
  expect(fused.filter(({ operations }) => operations.some((one) => one.kind === 'pass' && one.nodes)).length).toBeGreaterThan(5);
});
