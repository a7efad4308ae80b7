import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import { compareTwins, expectSameGraphs } from '../browser/fusion-compare.ts';
import { useModule } from '../support/browser.ts';
import { EXACT_EFFECTS, type GraphPlan, passes, type Twins, twins } from '../support/fusion-kit.ts';

const page = useModule('tests/browser/fusion.page.ts');

/** The size of the view: its pixels have no exact normalized positions. */
const SIZE = [63, 31];

/** A filter that outputs one read of its layer, turned, so that a read of another pixel shows. */
function reading(read: string, before = ''): string {
  return `/*{ "ISFVSN": "2", "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" }, { "NAME": "shift", "TYPE": "long", "VALUES": [0, 5], "DEFAULT": 5 }] }*/
${before}
void main() { vec4 color = ${read}; gl_FragColor = vec4(color.bgr, color.a); }`;
}

/** Two filters that compute with `gl_FragCoord`, `discard` and variables of the file, which the fused passes share. */
const STRIPES = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
vec2 cell = floor(gl_FragCoord.xy / 5.0);
void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  if (mod(cell.x + cell.y, 4.0) < 0.5) discard;
  gl_FragColor = vec4(1.0 - color.rgb, color.a * fract(gl_FragCoord.y / 20.0 + 0.3));
}`;

/** Cheaper than a texture. */
const INVERT = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() { vec4 color = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(1.0 - color.rgb, color.a); }`;

/** Each pixel reads another one, at whole pixels. */
const READS: readonly (readonly [name: string, text: string])[] = [
  ['to the right', reading('IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(3.0, -2.0))')],
  ['beyond all edges', reading('IMG_PIXEL(inputImage, floor(gl_FragCoord.xy) * 3.0 - RENDERSIZE + 0.5)')],
  ['by a whole param', reading('IMG_PIXEL(inputImage, gl_FragCoord.xy - vec2(shift, 1))')],
  ['of the middle of blocks', reading('IMG_PIXEL(inputImage, floor(gl_FragCoord.xy / 6.0) * 6.0 + 3.5)')],
  ['mirrored', reading('IMG_NORM_PIXEL(inputImage, vec2(1.0 - isf_FragNormCoord.x, isf_FragNormCoord.y))')],
  [
    'by a function, over pixels by the size',
    reading('at(vec2(2.0, 7.0))', 'vec4 at(vec2 by) { return IMG_NORM_PIXEL(inputImage, isf_FragNormCoord + by / RENDERSIZE); }'),
  ],
  ['by texelFetch', reading('texelFetch(inputImage, ivec2(gl_FragCoord.yx) - 3, 0)')],
];

/** pattern → the filters → screen. */
function through(sources: Readonly<Record<string, string>>, types: readonly string[]): Twins {
  const nodes = Object.fromEntries(types.map((type, i) => [`e-${i}`, { type: `filter/${type}`, version: 1 }]));
  const wires = types.map((_, i) => `${i === 0 ? 'pattern-a' : `e-${i - 1}`}.layer -> e-${i}.inputImage`);
  return twins(
    nodes,
    [...wires, `e-${types.length - 1}.layer -> screen-a.layer`],
    Object.fromEntries(Object.entries(sources).map(([name, text]) => [`${name}.fs`, text])),
  );
}

/** Draws both programs and expects the same image, with tones in it. The last pass holds the filters with these numbers. */
async function expectSame(pair: Twins, filters: readonly number[]): Promise<void> {
  expect(passes(pair.fused).at(-1)?.nodes).toEqual(filters.map((i) => `e-${i}`));
  const [difference] = await compareTwins(page, [pair], ...SIZE);
  expect(difference).toMatchObject({ differing: 0, most: 0 });
  expect(difference?.tones).toBeGreaterThan(0.1);
}

describe('a filter that reads one other pixel exactly takes the passes before it into its own', () => {
  test.each(READS)('%s', async (_, read) => {
    // The pattern computes with the normalized position: it keeps a pass of its own.
    await expectSame(through({ read, stripes: STRIPES }, ['sepia', 'stripes', 'read', 'sepia']), [0, 1, 2, 3]);
  });

  test('and such a filter before it', async () => {
    const [[, first = ''] = [], , , [, second = ''] = []] = READS;
    await expectSame(through({ first, second, stripes: STRIPES }, ['stripes', 'first', 'stripes', 'second', 'stripes']), [0, 1, 2, 3, 4]);
  });

  test('with what the reader itself computes of its position, before and after', async () => {
    const read = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/
void main() {
  gl_FragColor = vec4(gl_FragCoord.x / RENDERSIZE.x);
  gl_FragColor.gba = IMG_PIXEL(inputImage, gl_FragCoord.xy + 4.0).gba;
  if (mod(floor(gl_FragCoord.x), 7.0) < 0.5) discard;
  gl_FragColor.b *= isf_FragNormCoord.y;
}`;
    await expectSame(through({ read, stripes: STRIPES }, ['stripes', 'read']), [0, 1]);
  });
});

describe('a layer is computed again for each of its readers', () => {
  const NODES = {
    'grey-a': { type: 'filter/grey', version: 1, params: { amount: 0.5 } },
    'one-a': { type: 'filter/sepia', version: 1 },
    'blur-a': { type: 'filter/gaussian-blur', version: 1, params: { radius: 3 } },
    'two-a': { type: 'filter/luminance-variation', version: 1 },
    'blend-a': { type: 'operator/blend', version: 1, params: { mode: 1 } },
  };
  const WIRES = [
    'pattern-a.layer -> grey-a.inputImage',
    'grey-a.layer -> one-a.inputImage',
    'grey-a.layer -> two-a.inputImage',
    'one-a.layer -> blur-a.inputImage',
    'blur-a.layer -> blend-a.top',
    'two-a.layer -> blend-a.bottom',
    'blend-a.layer -> screen-a.layer',
  ];

  test('which are in two passes', async () => {
    const pair = twins(NODES, WIRES);
    expect(passes(pair.fused).filter(({ nodes }) => nodes?.includes('grey-a'))).toHaveLength(2);
    const [difference] = await compareTwins(page, [pair], ...SIZE);
    expect(difference).toMatchObject({ differing: 0 });
    expect(difference?.tones).toBeGreaterThan(0.1);
  });

  test('of which one reads several pixels of it', async () => {
    const nodes = {
      'pattern-a': { type: 'generator/pattern', version: 1, unfused: true },
      'invert-a': { type: 'filter/invert', version: 1 },
      'slope-a': { type: 'filter/slope', version: 1 },
    };
    const wires = ['pattern-a.layer -> invert-a.inputImage', 'invert-a.layer -> slope-a.inputImage', 'slope-a.layer -> screen-a.layer'];
    const pair = twins(nodes, wires, { 'slope.fs': EXACT_EFFECTS['filter/slope'] ?? '', 'invert.fs': INVERT });
    expect(passes(pair.fused).map((pass) => pass.nodes)).toEqual([undefined, ['invert-a', 'slope-a']]);
    const [difference] = await compareTwins(page, [pair], ...SIZE);
    expect(difference).toMatchObject({ differing: 0 });
    expect(difference?.tones).toBeGreaterThan(0.1);
  });
});

test('random graphs with such effects draw what they drew in passes', async () => {
  const types = ['filter/grey', 'filter/sepia', 'filter/gaussian-blur', 'operator/blend', 'operator/mask', ...Object.keys(EXACT_EFFECTS)];
  const plan = fc.array(fc.tuple(fc.constantFrom(...types), fc.array(fc.nat(3), { minLength: 2, maxLength: 2 })), {
    minLength: 4,
    maxLength: 9,
  });
  const plans: GraphPlan[] = fc.sample(plan, { seed: 11, numRuns: 12 });
  const { separate, fused } = await expectSameGraphs(page, plans);
  expect(passes(fused).length).toBeLessThan(passes(separate).length);
});
