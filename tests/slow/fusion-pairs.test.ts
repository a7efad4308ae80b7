import process from 'node:process';
import { expect, test } from '@jest/globals';
import fc from 'fast-check';
import type { Program } from '../../export/program/program.ts';
import { compareTwins, expectSameGraphs, expectSameImages } from '../browser/fusion-compare.ts';
import { useModule } from '../support/browser.ts';
import { chain, definitionOf, EFFECTS, identityOf, PAIR_PARTS, pairsOfEffects, passes, QUICK_PAIR_PARTS } from '../support/fusion-kit.ts';

const page = useModule('tests/browser/fusion.page.ts');

/** All parts but those of `npm test`. A graph of a pair is drawn in 80 ms, because many share a program. */
const PARTS = Array.from({ length: PAIR_PARTS }, (_, part) => part).filter((part) => !QUICK_PAIR_PARTS.includes(part));

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
const NOISE = 'fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * vec4(43758.545, 22578.145, 19642.349, 31415.927)) - 0.5';

/** The program with noise before each rounding to 8 bits inside of its shaders. */
function noisy(program: Program): Program {
  const noise = (color: string) => `clamp(roundEven(${color}), 0.0, 255.0)`;
  const withNoise = (text: string) =>
    text
      .replace('roundEven(clamp(color, 0.0, 1.0) * 255.0)', noise(`clamp(color, 0.0, 1.0) * 255.0 + ${NOISE}`))
      .replace(
        'vec4 scrim_clampedAs8(vec4 color) { return roundEven(color * 255.0)',
        `vec4 scrim_clampedAs8(vec4 color) { return ${noise(`color * 255.0 + ${NOISE}`)}`,
      )
      .replace(
        'vec3 scrim_clampedAs8(vec3 color) { return roundEven(color * 255.0)',
        `vec3 scrim_clampedAs8(vec3 color) { return ${noise(`color * 255.0 + (${NOISE}).rgb`)}`,
      );
  return { ...program, shaders: program.shaders.map((shader) => ({ ...shader, fragment: withNoise(shader.fragment) })) };
}

test('few effects turn a step of their input into more than sixteen', async () => {
  const chains = EFFECTS.map((type) => chain([type]));
  const found = await compareTwins(
    page,
    chains.map(({ fused, wires }) => ({ separate: fused, fused: noisy(fused), wires })),
  );
  // Effects that are not fused with the pattern have no rounding in their shader.
  const fused = chains.filter(({ fused: { operations } }) => operations.length === 1);
  expect(found.filter(({ differing }) => differing > 0).length).toBeGreaterThanOrEqual(fused.length * 0.9);
  const unstable = EFFECTS.filter((_, i) => (found[i]?.most ?? 0) > 16);
  // Two that jump, and two of high contrast: a skin color of narrow bounds, and a table of any colors.
  expect(unstable).toEqual(['filter/posterize', 'filter/skin-mask', 'filter/threshold', 'operator/color-lut']);
});

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
  for (let first = 0; first < graphs.length; first += AT_ONCE) {
    const { separate, fused } = await expectSameGraphs(page, graphs.slice(first, first + AT_ONCE));
    expect(passes(fused).length).toBeLessThan(passes(separate).length / 2);
  }
});
