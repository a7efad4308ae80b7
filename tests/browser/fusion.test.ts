import { describe, expect, test } from '@jest/globals';
import type { Program } from '../../export/program/program.ts';
import { useModule } from '../support/browser.ts';
import { chain, EFFECTS, passes, type Twins, twins } from '../support/fusion-kit.ts';
import { LIBRARY } from '../support/library.ts';
import { compareTwins, expectSameImages } from './fusion-compare.ts';

const page = useModule('tests/browser/fusion.page.ts');

/** Draws both programs and expects the same image, with tones in it, from the number of passes. */
async function expectOnePass(pair: Twins, passCount = 1): Promise<void> {
  expect(passes(pair.fused)).toHaveLength(passCount);
  expect(passes(pair.separate).length).toBeGreaterThan(passCount);
  const [difference] = await compareTwins(page, [pair]);
  expect(difference).toMatchObject({ differing: 0, most: 0 });
  expect(difference?.tones).toBeGreaterThan(0.1);
}

function count(programs: readonly Program[]): number {
  return programs.reduce((sum, program) => sum + passes(program).length, 0);
}

describe('a fused pass draws what the passes drew', () => {
  test('of a third of the effects, each before another one', async () => {
    // `tests/slow/fusion-pairs.test.ts` draws the others.
    const pairs = EFFECTS.flatMap((type, i) => (i % 3 === 0 ? [chain([type, EFFECTS[(i * 2 + 5) % EFFECTS.length] ?? type])] : []));
    await expectSameImages(page, pairs);
    // Each pair can save one pass; the drawing and painting filters have up to five that stay.
    expect(count(pairs.map(({ fused }) => fused))).toBeLessThan(count(pairs.map(({ separate }) => separate)) * 0.85);
  });

  test('of eight pointwise effects and their source', async () => {
    const types = ['sepia', 'posterize', 'vignette', 'threshold', 'film-grain', 'curves', 'white-balance', 'luminance-variation'];
    await expectOnePass(chain(types.map((type) => `filter/${type}`)));
  });

  test('of a diamond, whose layers two passes read', async () => {
    const nodes = {
      'grey-a': { type: 'filter/grey', version: 1, params: { amount: 0.5 } },
      'sepia-a': { type: 'filter/sepia', version: 1 },
      'post-a': { type: 'filter/posterize', version: 1 },
      'blend-a': { type: 'operator/blend', version: 1, params: { mode: 1 } },
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'grey-a.layer -> sepia-a.inputImage',
      'grey-a.layer -> post-a.inputImage',
      'sepia-a.layer -> blend-a.top',
      'post-a.layer -> blend-a.bottom',
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

  test('of scene layers, which are rounded to half floats', async () => {
    await expectOnePass(chain(['filter/to-scene', 'filter/hdr-exposure', 'filter/hdr-exposure', 'filter/tone-map']));
  });

  test('after a blur, whose last step takes the effects after it', async () => {
    await expectOnePass(chain(['filter/gaussian-blur', 'filter/sepia', 'filter/posterize']), 3);
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

  test('and a driver’s message about it names the node and the line of its file', async () => {
    const { fused } = chain(['filter/sepia', 'filter/posterize']);
    const [pass] = passes(fused);
    expect(pass?.nodes).toEqual(['pattern-a', 'e-0', 'e-1']);
    const map = fused.shaders[pass?.shader ?? 0]?.sourceMap;
    expect(map?.nodes).toEqual(['pattern-a', 'e-0', 'e-1']);
    const lines = fused.shaders[pass?.shader ?? 0]?.fragment.split('\n') ?? [];
    const place = map?.lines[lines.findIndex((line) => line.includes('b2_a_levels') && !line.startsWith('uniform'))];
    expect(map?.sources[place?.[0] ?? 0]).toBe('filters/posterize.fs');
    expect(LIBRARY.shader('filters/posterize.fs')?.split('\n')[(place?.[1] ?? 0) - 1]).toContain('levels');
  });
});
