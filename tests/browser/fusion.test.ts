import { describe, expect, test } from '@jest/globals';
import { useModule } from '../support/browser.ts';
import {
  chain,
  pairsOfChangedEffects,
  pairsOfEffects,
  passes,
  QUICK_PAIR_PARTS,
  type Twins,
  twins,
  versionOf,
} from '../support/fusion-kit.ts';
import { LIBRARY } from '../support/library.ts';
import type { StereoFrame } from './fusion.page.ts';
import { compareTwins, expectSameGraphs, expectSameImages } from './fusion-compare.ts';

const page = useModule('tests/browser/fusion.page.ts');

/** Draws both programs and expects the same image, with tones in it, from the number of passes. */
async function expectOnePass(pair: Twins, passCount = 1): Promise<void> {
  expect(passes(pair.fused)).toHaveLength(passCount);
  expect(passes(pair.separate).length).toBeGreaterThan(passCount);
  const [difference] = await compareTwins(page, [pair]);
  expect(difference).toMatchObject({ differing: 0, most: 0 });
  expect(difference?.tones).toBeGreaterThan(0.1);
}

describe('a fused pass draws what the passes drew', () => {
  const own = (body: string, more = '') =>
    `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]${more} }*/\nvoid main() { ${body} }`;

  test.each(QUICK_PAIR_PARTS)('of a tenth of all pairs of effects: part %d of 20', async (part) => {
    // `tests/slow/fusion-pairs.test.ts` draws others.
    const { separate, fused } = await expectSameGraphs(page, pairsOfEffects(part));
    // The drawing and painting filters have up to five passes that stay.
    expect(passes(fused).length).toBeLessThan(passes(separate).length * 0.85);
  });

  test('of all pairs with an effect that the last commit or the working tree changes', async () => {
    const pairs = pairsOfChangedEffects();
    const { separate } = await expectSameGraphs(page, pairs);
    expect(passes(separate).length).toBeGreaterThanOrEqual(pairs.length);
  });

  test('of nine pointwise effects and their source', async () => {
    const types = [
      'sepia',
      'chrominance-variation',
      'vignette',
      'color-temperature',
      'film-grain',
      'gradient-map',
      'curves',
      'white-balance',
      'luminance-variation',
    ];
    await expectOnePass(chain(types.map((type) => `filter/${type}`)));
  });

  test('of effects over an opaque image, which is not divided by its alpha', async () => {
    const opaque =
      '/*{ "ISFVSN": "2" }*/\nvoid main() { gl_FragColor = vec4(fract(gl_FragCoord.xy / vec2(37.0, 29.0)), isf_FragNormCoord.x, 1.0); }';
    const types = ['sepia', 'chrominance-variation', 'vignette', 'film-grain', 'curves', 'white-balance'];
    const nodes = Object.fromEntries(types.map((type) => [`${type}-a`, { type: `filter/${type}`, version: versionOf(`filter/${type}`) }]));
    const path = ['opaque-a', ...types.map((type) => `${type}-a`)];
    const wires = types.map((type, i) => `${path[i]}.layer -> ${type}-a.inputImage`);
    const pair = twins(
      { 'opaque-a': { type: 'generator/opaque', version: 1 }, ...nodes },
      [...wires, 'white-balance-a.layer -> screen-a.layer'],
      { 'opaque.fs': opaque },
    );
    await expectOnePass(pair);
    expect(pair.fused.shaders.filter(({ fragment }) => fragment.includes('scrim_straight'))).toEqual([]);
  });

  test('of effects that color the transparent image of a camera that is not there', async () => {
    const lit = own('vec4 color = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(color.rgb * 0.5 + 0.3, color.a);');
    const nodes = {
      'video-a': { type: 'source/camera-video', version: 1 },
      'lit-a': { type: 'filter/lit', version: 1 },
      'warm-a': { type: 'filter/color-temperature', version: versionOf('filter/color-temperature') },
      'again-a': { type: 'filter/lit', version: 1 },
      'blend-a': { type: 'operator/blend', version: versionOf('operator/blend') },
    };
    const wires = [
      'video-a.layer -> lit-a.inputImage',
      'lit-a.layer -> warm-a.inputImage',
      'warm-a.layer -> again-a.inputImage',
      'again-a.layer -> blend-a.top',
      'pattern-a.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ];
    await expectOnePass(twins(nodes, wires, { 'lit.fs': lit }));
  });

  test('of a filter in a shape: the mask has no pass of its own', async () => {
    const nodes = {
      'shape-a': { type: 'generator/shape-mask', version: 1, params: { shape: 1, size: [0.9, 0.6], rotation: 0.4, feather: 0.2 } },
      'grey-a': { type: 'filter/grey', version: versionOf('filter/grey') },
      'matte-a': { type: 'operator/choose-by-mask', version: versionOf('operator/choose-by-mask') },
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'grey-a.layer -> matte-a.inside',
      'pattern-a.layer -> matte-a.outside',
      'shape-a.layer -> matte-a.mask',
      'matte-a.layer -> screen-a.layer',
    ];
    await expectOnePass(twins(nodes, wires));
  });

  test('of a diamond, whose layers two passes read', async () => {
    const nodes = {
      'grey-a': { type: 'filter/grey', version: 1, params: { amount: 0.5 } },
      'sepia-a': { type: 'filter/sepia', version: 1 },
      'pale-a': { type: 'filter/luminance-variation', version: 1 },
      'blend-a': { type: 'operator/blend', version: 1, params: { mode: 1 } },
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'grey-a.layer -> sepia-a.inputImage',
      'grey-a.layer -> pale-a.inputImage',
      'sepia-a.layer -> blend-a.top',
      'pale-a.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ];
    await expectOnePass(twins(nodes, wires));
  });

  test('of objects, whose multisampled layers are drawn into the same samples', async () => {
    const box = (name: string, x: number, z: number) => ({
      [`box-${name}`]: { type: 'objects/primitive', version: 1 },
      [`place-${name}`]: { type: 'objects/transform', version: 1, params: { positionM: [x, 0, z] } },
      [`scene-${name}`]: { type: 'layer/scene', version: 1 },
    });
    const nodes = {
      'sun-a': { type: 'light/directional', version: 1 },
      ...box('a', -0.1, -0.8),
      ...box('b', 0.1, -1.2),
      'sepia-a': { type: 'filter/sepia', version: 1 },
      'over-a': { type: 'operator/over', version: 1, params: { opacity: 0.8 } },
      'fog-a': { type: 'filter/fog', version: 1, params: { far: 3 } },
      'grey-a': { type: 'filter/grey', version: 1 },
    };
    const wires = [
      ...['a', 'b'].flatMap((name) => [
        `box-${name}.objects -> place-${name}.objects`,
        `place-${name}.objects -> scene-${name}.objects`,
        `sun-a.lights -> scene-${name}.lights`,
      ]),
      'scene-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> over-a.top',
      'scene-b.layer -> over-a.bottom',
      'over-a.layer -> fog-a.inputImage',
      'fog-a.layer -> grey-a.inputImage',
      'grey-a.layer -> screen-a.layer',
    ];
    // Viewed layers have samples of their own.
    const { separate } = twins(nodes, wires, {}, { taps: ['scene-a.layer', 'scene-b.layer'] });
    const { fused } = twins(nodes, wires);
    expect(passes(fused).map(({ target }) => target)).toEqual(['sepia-a.layer', 'over-a.layer.depth', 'screen']);
    const [difference] = await compareTwins(page, [{ separate, fused, wires: [] }]);
    expect(difference).toMatchObject({ differing: 0 });
    expect(difference?.tones).toBeGreaterThan(0.05);
  });

  test('of colors with little alpha, at a size whose pixels have no exact normalized positions', async () => {
    // Filtering would mix in a little of the next pixel, which the division by alpha makes visible.
    const fade = own('vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(1.0 - c.rgb, c.a * fract(gl_FragCoord.y / 20.0 + 0.3));');
    const nodes = { 'fade-a': { type: 'filter/fade', version: 1 }, 'again-a': { type: 'filter/fade', version: 1 } };
    const pair = twins(nodes, through('fade', 'again'), { 'fade.fs': fade });
    for (const size of [
      [63, 31],
      [60, 30],
    ]) {
      const [difference] = await compareTwins(page, [pair], ...size);
      expect(difference).toMatchObject({ differing: 0 });
      expect(difference?.tones).toBeGreaterThan(0.1);
    }
  });

  test('of scene layers, which are rounded to half floats', async () => {
    await expectOnePass(chain(['filter/to-scene', 'filter/hdr-exposure', 'filter/hdr-exposure', 'filter/tone-map']));
  });

  test('after a blur, whose last step takes the effects after it', async () => {
    await expectOnePass(chain(['filter/gaussian-blur', 'filter/sepia', 'filter/grey']), 3);
  });

  test('of files that use the same names, sizes, `discard` and PASSINDEX', async () => {
    const file = (body: string, more = '') => `/*{ "ISFVSN": "2", "INPUTS": [
  { "NAME": "inputImage", "TYPE": "image" }, { "NAME": "amount", "TYPE": "float", "DEFAULT": 0.3 }]${more} }*/
struct Mixed { vec3 color; float amount; };
float gain = 0.9;
Mixed mixed(vec4 from) { gain += 0.05; return Mixed(from.rgb * gain, amount); }
void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  Mixed one = mixed(color);
  ${body}
}`;
    const sources = {
      'one.fs': file(
        'vec2 at = gl_FragCoord.xy / IMG_SIZE(inputImage); gl_FragColor = vec4(mix(one.color, vec3(at, 0.5), one.amount), color.a);',
      ),
      'two.fs': file('if (color.r > 0.7) discard; gl_FragColor = vec4(one.color.bgr, color.a);'),
      'three.fs': file('gl_FragColor = vec4(one.color, float(PASSINDEX) + color.a) * vec4(vec3(gl_FragCoord.x / RENDERSIZE.x), 1.0);'),
    };
    const nodes = Object.fromEntries(
      Object.keys(sources).map((name) => [`${name.replace('.fs', '')}-a`, { type: `filter/${name.replace('.fs', '')}`, version: 1 }]),
    );
    const wires = [
      'pattern-a.layer -> one-a.inputImage',
      'one-a.layer -> two-a.inputImage',
      'two-a.layer -> three-a.inputImage',
      'three-a.layer -> screen-a.layer',
    ];
    await expectOnePass(twins(nodes, wires, sources));
  });

  const through = (...names: readonly string[]) => [
    ...names.map((name, i) => `${i === 0 ? 'pattern' : names[i - 1]}-a.layer -> ${name}-a.inputImage`),
    `${names.at(-1)}-a.layer -> screen-a.layer`,
  ];

  test('of a filter before one that keeps its own image between frames', async () => {
    const body = 'gl_FragColor = mix(IMG_THIS_PIXEL(inputImage), IMG_THIS_PIXEL(kept), TIME > 0.0 ? 0.7 : 0.0);';
    const sources = { 'trail.fs': own(body, ', "PASSES": [{ "TARGET": "kept", "PERSISTENT": true }]') };
    const nodes = {
      'gray-a': { type: 'filter/grey', version: 1 },
      'trail-a': { type: 'filter/trail', version: 1 },
      'again-a': { type: 'filter/trail', version: 1 },
      'sepia-a': { type: 'filter/sepia', version: 1 },
    };
    const pair = twins(nodes, through('gray', 'trail', 'sepia', 'again'), sources);
    expect(passes(pair.fused).length).toBeLessThan(passes(pair.separate).length);
    await expectSameImages(page, [pair]);
  });

  test('but not of a read at the pixels of another image of another size', async () => {
    const half = ', "PASSES": [{ "TARGET": "half", "WIDTH": "$WIDTH / 2" }, {}]';
    const read = 'IMG_PIXEL(inputImage, IMG_SIZE(half) * isf_FragNormCoord)';
    const body = `gl_FragColor = PASSINDEX == 0 ? IMG_THIS_PIXEL(inputImage) : ${read};`;
    const nodes = { 'gray-a': { type: 'filter/grey', version: 1 }, 'half-a': { type: 'filter/half', version: 1 } };
    await expectSameImages(page, [twins(nodes, through('gray', 'half'), { 'half.fs': own(body, half) })]);
  });

  test('and an effect at its identity stays after colors that exceed their alpha, which it clamps', async () => {
    const glow = own('gl_FragColor = vec4(IMG_THIS_PIXEL(inputImage).rgb, 0.1);', ', "SCRIM_ALPHA": "premultiplied"');
    const nodes = {
      'glow-a': { type: 'filter/glow', version: 1 },
      'grey-a': { type: 'filter/grey', version: 1, params: { amount: 0 } },
      'over-a': { type: 'operator/over', version: LIBRARY.definition('operator/over')?.version },
    };
    const wires = [
      'pattern-a.layer -> glow-a.inputImage',
      'glow-a.layer -> grey-a.inputImage',
      'grey-a.layer -> over-a.top',
      'other-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    ];
    const { separate } = twins(nodes, wires, { 'glow.fs': glow });
    const { fused } = twins(nodes, wires, { 'glow.fs': glow }, { fold: true });
    await expectSameImages(page, [{ separate, fused, wires: [] }]);
  });

  test('and of a graph whose constants, equal effects and invisible layers are folded', async () => {
    const version = (type: string) => ({ type, version: LIBRARY.definition(type)?.version });
    const nodes = {
      'third-a': { ...version('value/math'), params: { operation: 'divide', a: 1, b: 3 } },
      'grey-a': version('filter/grey'),
      'pale-a': { ...version('filter/grey'), params: { amount: { expression: '1 / 3' } } },
      'blend-a': { ...version('operator/blend'), params: { mode: 2 } },
      'scene-a': version('layer/scene'),
      'box-a': version('objects/primitive'),
      'over-a': { ...version('operator/over'), params: { opacity: 0 } },
      'warm-a': version('filter/color-temperature'),
    };
    const wires = [
      'third-a.result -> grey-a.amount',
      'pattern-a.layer -> grey-a.inputImage',
      'pattern-a.layer -> pale-a.inputImage',
      'grey-a.layer -> blend-a.top',
      'pale-a.layer -> blend-a.bottom',
      'box-a.objects -> scene-a.objects',
      'scene-a.layer -> over-a.top',
      'blend-a.layer -> over-a.bottom',
      'over-a.layer -> warm-a.inputImage',
      'warm-a.layer -> screen-a.layer',
    ];
    const { separate } = twins(nodes, wires);
    const { fused } = twins(nodes, wires, {}, { fold: true });
    expect(separate.operations.map(({ kind }) => kind)).toEqual(expect.arrayContaining(['value', 'draw']));
    expect(fused.operations.map(({ kind, id }) => `${kind} ${id}`)).toEqual(['pass warm-a.pass0']);
    expect(passes(fused)[0]?.nodes).toEqual(['pattern-a', 'pale-a', 'blend-a', 'warm-a']);
    await expectSameImages(page, [{ separate, fused, wires: [] }]);
  });

  test('and a driver’s message about it names the node and the line of its file', async () => {
    const { fused } = chain(['filter/sepia', 'filter/vignette']);
    const [pass] = passes(fused);
    expect(pass?.nodes).toEqual(['pattern-a', 'e-0', 'e-1']);
    const map = fused.shaders[pass?.shader ?? 0]?.sourceMap;
    expect(map?.nodes).toEqual(['pattern-a', 'e-0', 'e-1']);
    const lines = fused.shaders[pass?.shader ?? 0]?.fragment.split('\n') ?? [];
    const place = map?.lines[lines.findIndex((line) => line.includes('b2_a_amount') && !line.startsWith('uniform'))];
    expect(map?.sources[place?.[0] ?? 0]).toBe('filters/vignette.fs');
    expect(LIBRARY.shader('filters/vignette.fs')?.split('\n')[(place?.[1] ?? 0) - 1]).toContain('amount');
  });
});

describe('two views', () => {
  /** A scene over a blurred pattern: pattern and blur, three passes, do not depend on the view. */
  const { separate } = twins(
    {
      'blur-a': { type: 'filter/gaussian-blur', version: 1, params: { radius: 3 } },
      'box-a': { type: 'objects/primitive', version: 1 },
      'scene-a': { type: 'layer/scene', version: 1 },
      'blend-a': { type: 'operator/blend', version: 1 },
    },
    [
      'pattern-a.layer -> blur-a.inputImage',
      'box-a.objects -> scene-a.objects',
      'scene-a.layer -> blend-a.top',
      'blur-a.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ],
  );

  test('share the passes that do not depend on the view', async () => {
    const { draws, left, right } = await page.call<StereoFrame>('drawStereo', separate);
    const different = await page.call<StereoFrame>('drawStereo', separate, 20);
    // Views of different sizes need all passes twice.
    expect(draws).toBe(different.draws - 3);
    expect([...left]).toEqual([...right]);
    expect(new Set(left).size).toBeGreaterThan(30);
  });
});
