import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { createCompiler } from '../../export/compiler/compile.ts';
import { loadProject } from '../../export/graph/load.ts';
import { filteredObjects, filteredProject } from '../../tools/bench/filtered-project.ts';
import { type FrameTraffic, frameTraffic } from '../../tools/bench/frame-traffic.ts';
import { chain, passes, type Twins, twins } from '../support/fusion-kit.ts';
import { LIBRARY } from '../support/library.ts';
import { TESTS_FOLDER } from '../support/this-test.ts';

const SIZE = { widthPx: 1280, heightPx: 720 } as const;
const LAYER_BYTES = SIZE.widthPx * SIZE.heightPx * 4;
const EIGHT = [
  'sepia',
  'chrominance-variation',
  'vignette',
  'color-temperature',
  'film-grain',
  'curves',
  'white-balance',
  'luminance-variation',
];
const { compile } = createCompiler();

function traffic({ separate, fused }: Pick<Twins, 'separate' | 'fused'>): {
  readonly apart: FrameTraffic;
  readonly together: FrameTraffic;
} {
  return { apart: frameTraffic(separate, SIZE), together: frameTraffic(fused, SIZE) };
}

/** A shipped example, with and without fusion. */
async function example(
  name: string,
  change = (text: string) => text,
  opaqueModels: readonly string[] = [],
): Promise<Pick<Twins, 'separate' | 'fused'>> {
  const text = change(await readFile(join(TESTS_FOLDER, '../examples', name, 'project.scrim.json'), 'utf8'));
  const project = loadProject({ project: text, layout: null, sources: {} }).output;
  const made = [false, true].map((fuse) => project && compile({ project, library: LIBRARY, options: { fuse, opaqueModels } }).output);
  const [separate, fused] = made;
  if (!separate || !fused) throw new Error(`${name} does not compile.`);
  return { separate, fused };
}

describe('a frame needs', () => {
  test('one pass for eight pointwise effects, which reads and writes each pixel once', () => {
    const { apart, together } = traffic(chain(EIGHT.map((type) => `filter/${type}`)));
    expect(apart).toMatchObject({ passes: 9, targets: 2, readBytes: 8 * LAYER_BYTES, writtenBytes: 9 * LAYER_BYTES });
    expect(together).toMatchObject({ passes: 1, targets: 0, targetBytes: 0, readBytes: 0, writtenBytes: LAYER_BYTES });
  });

  test('one pass for eight pointwise effects over an image file, besides the one that fits it to views of another size', () => {
    const ids = ['file-a', ...EIGHT.map((type) => `${type}-a`), 'screen-a'];
    const filters = EIGHT.map((type) => [`${type}-a`, { type: `filter/${type}`, version: LIBRARY.definition(`filter/${type}`)?.version }]);
    const nodes = { 'file-a': { type: 'source/image-file', version: 1 }, ...Object.fromEntries(filters) };
    const wires = ids.slice(1).map((id, i) => `${ids[i]}.layer -> ${id}.${id === 'screen-a' ? 'layer' : 'inputImage'}`);
    const { fused } = twins(nodes, wires);
    expect(passes(fused).map(({ view, copies }) => [view, copies ?? false])).toEqual([
      ['once', false],
      ['each', true],
    ]);
  });

  test('three passes for five effects of which one is a blur: what is before it, across, and along with what is after it', () => {
    const { apart, together } = traffic(
      chain(['sepia', 'vignette', 'gaussian-blur', 'white-balance', 'curves'].map((type) => `filter/${type}`)),
    );
    expect(apart).toMatchObject({ passes: 7, targets: 2 });
    expect(together).toMatchObject({
      passes: 3,
      targets: 2,
      targetBytes: 2 * LAYER_BYTES,
      readBytes: 2 * LAYER_BYTES,
      writtenBytes: 3 * LAYER_BYTES,
    });
  });

  test('no pass of its own for figure 11 of the paper, a sketched shadow under objects', async () => {
    const { apart, together } = traffic(await example('sketchy-shadow'));
    expect([apart.passes, together.passes]).toEqual([0, 0]);
    expect([apart.targets, together.targets]).toEqual([0, 0]);
  });

  test('one pass instead of three, and the layers of shadow and objects alone, with a filter over all of figure 11', async () => {
    const pair = await example('sketchy-shadow', filteredProject);
    const { apart, together } = traffic(pair);
    expect([apart.passes, together.passes]).toEqual([3, 1]);
    expect([apart.targets, together.targets]).toEqual([3, 2]);
    expect(passes(pair.fused)[0]?.nodes).toEqual(['ground-f11', 'merge-f11', 'filter-all1']);
    expect(together.readBytes + together.writtenBytes).toBeLessThan((apart.readBytes + apart.writtenBytes) / 2);
  });

  test('half of the passes for a drawing where a mask of depth says so, and a third of the bytes less', async () => {
    const { apart, together } = traffic(await example('near-in-colour-far-in-ink'));
    expect([apart.passes, together.passes]).toEqual([4, 2]);
    expect([apart.targets, together.targets]).toEqual([3, 1]);
    expect(together.readBytes + together.writtenBytes).toBeLessThan((apart.readBytes + apart.writtenBytes) * 0.67);
  });

  test('one pass for a world that shows in the shape of objects, and the room around it in another light', async () => {
    const pair = await example('the-world-in-the-book');
    const { apart, together } = traffic(pair);
    expect([apart.passes, together.passes]).toEqual([4, 1]);
    expect(together.readBytes + together.writtenBytes).toBeLessThan(apart.readBytes + apart.writtenBytes);
    expect(passes(pair.fused).map(({ target }) => target)).toEqual(['screen']);
  });

  test('no pass and no target for filters over objects alone, without antialiasing', async () => {
    const filtered = (opaqueModels: readonly string[]) =>
      example('shadows-of-real-and-virtual-things', (text) => filteredObjects(text, 'scene-f6.layer'), opaqueModels);
    const { apart, together } = traffic(await filtered(['robot-tin1']));
    expect(apart).toMatchObject({ passes: 2, targets: 2, readBytes: 2 * LAYER_BYTES, writtenBytes: 2 * LAYER_BYTES });
    expect(together).toMatchObject({ passes: 0, targets: 0, targetBytes: 0, readBytes: 0, writtenBytes: 0 });
    // Objects that may be transparent keep their layer.
    expect(traffic(await filtered([])).together).toMatchObject({ passes: 1, targets: 1 });
  });
});
