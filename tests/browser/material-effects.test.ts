import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from '@jest/globals';
import { createRandom } from '../../export/runtime/random.ts';
import { useModule } from '../support/browser.ts';
import { type Twins, versionOf } from '../support/fusion-kit.ts';
import { type Effect, type FilteredScene, filteredScene, isInMaterials } from '../support/material-effects-kit.ts';
import { TESTS_FOLDER } from '../support/this-test.ts';
import type { Compared, CompareOptions } from './material-effects.page.ts';

const page = useModule('tests/browser/material-effects.page.ts');

const SEPIA: Effect = ['filter/sepia'];
const CHAIN: readonly Effect[] = [
  ['filter/luminance-variation', { gamma: 1.4 }],
  ['filter/white-balance', { swing: 0.4 }],
  ['filter/curves'],
  SEPIA,
];

function compare(pairs: readonly Twins[], options: CompareOptions = {}): Promise<Compared[]> {
  return page.call<Compared[]>(
    'compare',
    pairs.map(({ separate, fused }) => ({ separate, fused })),
    options,
  );
}

/** Expects that no channel differs by more than a step, and at most one of 10,000 at all. */
async function expectSame(scenes: readonly FilteredScene[], options: CompareOptions = {}): Promise<readonly Compared[]> {
  const found = await compare(
    scenes.map((scene) => filteredScene(scene)),
    options,
  );
  const wrong = found.flatMap((one, i) => (one.most <= 1 && one.differing <= one.channels / 10_000 ? [] : [{ scene: scenes[i], ...one }]));
  expect(wrong).toEqual([]);
  for (const { drawn } of found) expect(drawn).toBeGreaterThan(2000);
  return found;
}

const SCENES: readonly [string, FilteredScene][] = [
  ['of one effect', { effects: [SEPIA] }],
  ['of several, with a curve and one that depends on the clock', { effects: CHAIN }],
  ['behind the room', { effects: CHAIN, occlusion: {} }],
  [
    'of a scene layer that is tone mapped',
    { effects: [['filter/hdr-exposure'], ['filter/tone-map'], SEPIA], scene: { encoding: 'scene' } },
  ],
];

test.each(SCENES)('materials draw what passes over the layer draw: %s', async (_, scene) => {
  expect(isInMaterials(filteredScene(scene))).toBe(true);
  await expectSame([scene]);
});

test('of the materials of a model, copied', async () => {
  const node = (type: string, params: object) => ({ type, version: versionOf(type), params });
  const nodes = {
    'model-a': node('source/model', { model: 'robot' }),
    'copies-a': node('objects/copies', { count: 5, stepM: [0.25, 0, -0.1] }),
    'place-a': node('objects/transform', { positionM: [-0.5, -0.3, -0.9], scale: 1.5 }),
  };
  const wires = ['model-a.objects -> copies-a.objects', 'copies-a.objects -> place-a.objects', 'place-a.objects -> scene-a.objects'];
  const scene = { effects: CHAIN, occlusion: {}, nodes, wires, options: { opaqueModels: ['robot'] } };
  expect(isInMaterials(filteredScene(scene))).toBe(true);
  const file = new Uint8Array(await readFile(join(TESTS_FOLDER, '../examples/first-light/assets/robot.glb')));
  const [found, withoutModel] = await expectSame([scene, { effects: CHAIN, occlusion: {} }], { file });
  expect(found?.drawn).toBeGreaterThan((withoutModel?.drawn ?? 0) + 500);
});

test('before a pass that reads other pixels', async () => {
  const scene = { effects: [SEPIA, ['filter/gaussian-blur', { radius: 5 }]] } as const;
  expect(filteredScene(scene).fused.operations.some((operation) => 'effects' in operation)).toBe(true);
  await expectSame([scene]);
});

test('where two effects read the layer', async () => {
  const nodes = { 'mix-a': { type: 'operator/mix', version: 1 } };
  const mix = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "one", "TYPE": "image" }, { "NAME": "two", "TYPE": "image" }] }*/
void main() { vec4 a = IMG_THIS_PIXEL(one); vec4 b = IMG_THIS_PIXEL(two); gl_FragColor = vec4(abs(a.rgb - b.brg), a.a); }`;
  const wires = ['e-0.layer -> mix-a.one', 'scene-a.layer -> mix-a.two'];
  const scene = { effects: [SEPIA], nodes, wires, shown: 'mix-a.layer', sources: { 'mix.fs': mix } };
  expect(isInMaterials(filteredScene(scene))).toBe(true);
  await expectSame([scene]);
});

test('after a param has changed', async () => {
  await expectSame([{ effects: [['filter/sepia', { amount: 0 }]] }], { param: ['e-0', 'amount', 0.8] });
  const [changed] = await compare([filteredScene({ effects: [['filter/sepia', { amount: 0 }]] })], {
    param: ['e-0', 'amount', 0.8],
    onlySeparate: true,
  });
  expect(changed?.differing).toBeGreaterThan(10_000);
});

/** Effects that can be in materials, with ranges of their params. */
const RANGES: Readonly<Record<string, Readonly<Record<string, readonly [number, number]>>>> = {
  'filter/sepia': { amount: [0, 1] },
  'filter/grey': { amount: [0, 1] },
  'filter/luminance-variation': { brightness: [-0.2, 0.2], contrast: [0.5, 1], gamma: [0.6, 1.6] },
  'filter/chrominance-variation': { saturation: [0.3, 1.3] },
  'filter/color-temperature': {},
  'filter/white-balance': { balance: [0, 1] },
  'filter/curves': {},
};

test('random chains, behind the room or not', async () => {
  const { next } = createRandom(7, 'material effects');
  const types = Object.keys(RANGES);
  const scenes = Array.from({ length: 8 }, (): FilteredScene => {
    const drawn = Array.from({ length: 1 + Math.floor(next() * 6) }, (): Effect => {
      const type = types[Math.floor(next() * types.length)] ?? 'filter/sepia';
      const params = Object.entries(RANGES[type] ?? {}).map(([name, [from, to]]) => [name, from + next() * (to - from)]);
      return [type, Object.fromEntries(params)];
    });
    // Materials have textures for the tables of one Curves node.
    const curves = drawn.findIndex(([type]) => type === 'filter/curves');
    const effects = drawn.filter(([type], i) => type !== 'filter/curves' || i === curves);
    return next() < 0.5 ? { effects } : { effects, occlusion: { biasM: 0.02 * next() } };
  });
  expect(scenes.filter((scene) => !isInMaterials(filteredScene(scene)))).toEqual([]);
  await expectSame(scenes);
});

test('two views are the same, but for what the place on a screen that they share changes without effects too', async () => {
  const scenes = [{ effects: [['filter/sepia', { amount: 0 }]] as const }, { effects: [SEPIA] }];
  const found = await compare(
    scenes.map((scene) => filteredScene(scene)),
    { isStereo: true },
  );
  // At another place of a framebuffer, positions on a triangle are rounded in another way.
  for (const { differing, left, channels } of found) {
    expect(left).toBe(0);
    expect(differing).toBeLessThan(channels / 1000);
  }
});

test('on several samples, the effect of their mean is another: such layers stay', async () => {
  const effects: readonly Effect[] = [['filter/luminance-variation', { gamma: 2 }]];
  const { separate, wires } = filteredScene({ effects, antialias: true });
  expect(wires.map(({ reason }) => reason)).toContain('samples');
  const { fused } = filteredScene({ effects });
  const [found] = await compare([{ separate, fused, wires }], { onSamples: true });
  expect(found?.most).toBeGreaterThan(20);
});
