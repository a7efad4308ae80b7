import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import process from 'node:process';
import { expect, test } from '@jest/globals';
import fc from 'fast-check';
import { UNSTABLE_SHADERS } from '../../export/compiler/schedule/fuse/unstable-shaders.ts';
import type { Program } from '../../export/program/program.ts';
import { compareTwins, expectSameGraphs, expectSameImages } from '../browser/fusion-compare.ts';
import { useModule } from '../support/browser.ts';
import {
  chain,
  definitionOf,
  EFFECTS,
  identityOf,
  PAIR_PARTS,
  pairsOfEffects,
  passes,
  QUICK_PAIR_PARTS,
  type Twins,
} from '../support/fusion-kit.ts';
import { TESTS_FOLDER, updatesGoldens } from '../support/this-test.ts';

const page = useModule('tests/browser/fusion.page.ts');

/**
 * A third of the parts that `npm test` leaves out: each effect is before and after some 15 others. `SCRIM_PAIRS=all` draws all of them.
 * Pairs with an effect that has just changed are all drawn with `npm test`.
 */
const PARTS = Array.from({ length: PAIR_PARTS }, (_, part) => part)
  .filter((part) => !QUICK_PAIR_PARTS.includes(part))
  .filter((_, i) => process.env.SCRIM_PAIRS === 'all' || i % 3 === 0);

test.each(PARTS)('pairs of effects draw what they drew in passes of their own: part %d of 20', async (part) => {
  await expectSameGraphs(page, pairsOfEffects(part));
});

test('effects that are left out, because they say that they change nothing, change nothing', async () => {
  const left = EFFECTS.flatMap((type) => {
    const params = identityOf(type);
    if (params === null) return [];
    const { separate } = chain([type], [params]);
    const fused = chain([type], [params], { fold: true }).separate;
    return fused.operations.length < separate.operations.length ? [{ separate, fused, wires: [] }] : [];
  });
  expect(left.length).toBeGreaterThan(12);
  await expectSameImages(page, left);
});

const POINTWISE = EFFECTS.filter((type) => {
  const { lowering } = definitionOf(type);
  return lowering.kind === 'image' && lowering.access === 'pointwise';
});

/** Half a step of 8 bits, up or down, different at each pixel. */
const NOISE = '(fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * vec4(43758.545, 22578.145, 19642.349, 31415.927)) - 0.5) / 255.0';

/** A program of passes with noise before each rounding of a layer that fusion leaves no texture, except for effects that are kept apart. */
function noisy({ separate, wires }: Twins): Program {
  const stored = new Set(wires.flatMap(({ writer, reason }) => (reason === 'unstable' ? [] : [writer])));
  const rounding = passes(separate).filter(({ id, target }) => target !== 'screen' && !stored.has(id));
  const noisyShaders = new Set(rounding.map(({ shader }) => shader));
  const withNoise = (text: string) => text.replace(/scrim_output = (.*);/, `scrim_output = clamp($1 + ${NOISE}, 0.0, 1.0);`);
  return {
    ...separate,
    shaders: separate.shaders.map((shader, i) =>
      noisyShaders.has(i) ? { ...shader, id: `${shader.id}:noisy`, fragment: withNoise(shader.fragment) } : shader,
    ),
  };
}

test('the effects that turn noise of half a step into more than 16 are those that stay apart from what they read', async () => {
  const chains = EFFECTS.map((type) => chain([type]));
  const found = await compareTwins(
    page,
    chains.map((pair) => ({ ...pair, fused: noisy(pair) })),
  );
  expect(found.filter(({ differing }) => differing > 0).length).toBeGreaterThan(EFFECTS.length * 0.4);
  const unstable = EFFECTS.flatMap((type, i) => ((found[i]?.most ?? 0) > 16 ? [shaderOf(type)] : []));
  if (updatesGoldens()) await writeList(unstable);
  else expect(unstable.sort()).toEqual(UNSTABLE_SHADERS);
});

function shaderOf(type: string): string {
  const { lowering } = definitionOf(type);
  if (lowering.kind !== 'image') throw new Error(`${type} has no shader.`);
  return lowering.shader;
}

async function writeList(files: readonly string[]): Promise<void> {
  const path = join(TESTS_FOLDER, '../export/compiler/schedule/fuse/unstable-shaders.ts');
  const text = await readFile(path, 'utf8');
  const list = [...files].sort().map((file) => `  '${file}',\n`);
  await writeFile(path, text.replace(/= \[[^\]]*\]/, `= [\n${list.join('')}]`));
}

const plans = fc.array(
  fc.tuple(
    fc.nat(POINTWISE.length - 1).map((effect) => POINTWISE[effect] ?? 'filter/sepia'),
    fc.array(fc.nat(3), { minLength: 2, maxLength: 2 }),
  ),
  { minLength: 3, maxLength: 9 },
);

/** Fewer graphs while the fusion is changed: `SCRIM_GRAPHS=40 npm run test:one slow slow/fusion-pairs`. */
const GRAPHS = Number(process.env.SCRIM_GRAPHS ?? 500);
/** Graphs that share a program. */
const AT_ONCE = 50;

test('random graphs of effects draw what they drew in passes', async () => {
  const graphs = fc.sample(plans, { seed: 7, numRuns: GRAPHS });
  const count = { separate: 0, fused: 0 };
  for (let first = 0; first < graphs.length; first += AT_ONCE) {
    const { separate, fused } = await expectSameGraphs(page, graphs.slice(first, first + AT_ONCE));
    count.separate += passes(separate).length;
    count.fused += passes(fused).length;
  }
  expect(count.fused).toBeLessThan(count.separate / 2);
});
