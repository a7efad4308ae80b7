import process from 'node:process';
import { expect, test } from '@jest/globals';
import fc from 'fast-check';
import type { Program } from '../../export/program/program.ts';
import { compareTwins, expectSameImages } from '../browser/fusion-compare.ts';
import { useModule } from '../support/browser.ts';
import { chain, definitionOf, EFFECTS, layerPorts, type Twins, twins } from '../support/fusion-kit.ts';

const page = useModule('tests/browser/fusion.page.ts');

test('each effect before another one draws what it drew in passes of its own', async () => {
  await expectSameImages(
    page,
    EFFECTS.map((type, i) => chain([type, EFFECTS[(i * 2 + 5) % EFFECTS.length] ?? type])),
  );
});

/** Effects of which each reads one of the four latest layers at each of its inputs. */
function graphOf(plan: readonly (readonly [effect: number, inputs: readonly number[]])[]): Twins {
  const layers = ['pattern-a', 'other-a'];
  const nodes: Record<string, object> = {};
  const wires: string[] = [];
  for (const [effect, inputs] of plan) {
    const type = POINTWISE[effect] ?? 'filter/sepia';
    const id = `e-${layers.length}`;
    nodes[id] = { type, version: definitionOf(type).version };
    const latest = layers.slice(-4);
    wires.push(...layerPorts(type).map((port, i) => `${latest[(inputs[i] ?? 0) % latest.length]}.layer -> ${id}.${port}`));
    layers.push(id);
  }
  return twins(nodes, [...wires, `${layers.at(-1)}.layer -> screen-a.layer`]);
}

const POINTWISE = EFFECTS.filter((type) => {
  const { lowering } = definitionOf(type);
  return lowering.kind === 'image' && lowering.access === 'pointwise';
});

/** Half a step of 8 bits, up or down, different at each pixel. */
const NOISE = 'fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * vec4(43758.545, 22578.145, 19642.349, 31415.927)) - 0.5';

/** The program with noise before each rounding to 8 bits inside of its shaders. */
function noisy(program: Program): Program {
  const withNoise = (text: string) =>
    text.replace('roundEven(clamp(color, 0.0, 1.0) * 255.0)', `clamp(roundEven(clamp(color, 0.0, 1.0) * 255.0 + ${NOISE}), 0.0, 255.0)`);
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

const plans = fc.array(fc.tuple(fc.nat(POINTWISE.length - 1), fc.array(fc.nat(3), { minLength: 2, maxLength: 2 })), {
  minLength: 3,
  maxLength: 9,
});

/** More graphs for a change of the fusion: `SCRIM_GRAPHS=500 npm run test:one slow slow/fusion-pairs`. */
const GRAPHS = Number(process.env.SCRIM_GRAPHS ?? 40);
/** Graphs that one call of the page gets. */
const AT_ONCE = 25;

test('random graphs of effects draw what they drew in passes', async () => {
  const graphs = fc.sample(plans, { seed: 7, numRuns: GRAPHS });
  for (let i = 0; i < graphs.length; i += AT_ONCE) await expectSameImages(page, graphs.slice(i, i + AT_ONCE).map(graphOf));
});
