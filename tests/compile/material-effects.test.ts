import { describe, expect, test } from '@jest/globals';
import { describeProgram, describeSeparate } from '../../export/compiler/describe.ts';
import type { SeparateReason } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { totalBytes } from '../../export/compiler/target-bytes.ts';
import { mayRest } from '../../export/program/may-rest.ts';
import type { DrawEffects } from '../../export/program/program.ts';
import { passes, type Twins, versionOf } from '../support/fusion-kit.ts';
import { type Effect, type FilteredScene, filteredScene, isInMaterials, OBJECT_REASONS } from '../support/material-effects-kit.ts';
import { programFaults } from './program-faults.ts';

const SEPIA: Effect = ['filter/sepia'];
const GRAY: Effect = ['filter/grey'];
const own = (body: string, more = '') =>
  `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]${more} }*/\nvoid main() { ${body} }`;

function effectsOf({ fused }: Pick<Twins, 'fused'>): DrawEffects[] {
  return fused.operations.flatMap((operation) => ('effects' in operation && operation.effects ? [operation.effects] : []));
}

function node(type: string, params: object = {}, more: object = {}): object {
  return { type, version: versionOf(type), params, ...more };
}

describe('materials compute effects over a layer of opaque objects', () => {
  test('without a pass and without a target, straight to the screen', () => {
    const pair = filteredScene({ effects: [SEPIA, GRAY, ['filter/curves']] });
    expect(passes(pair.separate)).toHaveLength(3);
    expect(totalBytes(pair.separate)).toBeGreaterThan(0);
    expect(pair.wires).toEqual([]);
    expect(passes(pair.fused)).toEqual([]);
    expect(totalBytes(pair.fused)).toBe(0);
    expect(effectsOf(pair).map(({ nodes }) => nodes)).toEqual([['e-0', 'e-1', 'e-2']]);
    expect(programFaults(pair.fused)).toEqual([]);
    expect(pair.fused.presentation).toMatchObject({ mode: 'forward', antialias: false, screenDepth: 'whole' });
  });

  test('behind an occlusion, which stays in the draw', () => {
    const pair = filteredScene({ effects: [SEPIA], occlusion: {} });
    expect(isInMaterials(pair)).toBe(true);
    const [draw] = pair.fused.operations.flatMap((operation) => ('occlusion' in operation ? [operation] : []));
    expect(draw?.occlusion?.node).toBe('hide-a');
  });

  test('before a pass that stays, into its layer', () => {
    const pair = filteredScene({ effects: [SEPIA, ['filter/gaussian-blur', { radius: 4 }]] });
    const [draw] = pair.fused.operations.filter(({ kind }) => kind === 'draw');
    expect(draw).toMatchObject({ target: 'e-0.layer', writes: ['e-0.layer'], effects: { nodes: ['e-0'] } });
    expect(pair.fused.resources.map(({ id }) => id)).not.toContain('scene-a.layer');
    expect(pair.fused.resources).toContainEqual(expect.objectContaining({ id: 'e-0.layer', depth: 'window' }));
    expect(totalBytes(pair.fused)).toBeLessThan(totalBytes(pair.separate));
    expect(programFaults(pair.fused)).toEqual([]);
  });

  test('of models whose file has no transparent materials, moved, copied and grouped', () => {
    const nodes = {
      'model-a': node('source/model', { model: 'robot' }),
      'copies-a': node('objects/copies'),
      'group-a': node('objects/group'),
    };
    const wires = ['model-a.objects -> copies-a.objects', 'copies-a.objects -> group-a.objects', 'group-a.objects -> scene-a.objects'];
    const scene = (opaqueModels: readonly string[]) => filteredScene({ effects: [SEPIA], nodes, wires, options: { opaqueModels } });
    expect(isInMaterials(scene(['robot']))).toBe(true);
    expect(isInMaterials(scene([]))).toBe(false);
  });

  test('of objects that reach the scene in more ways than can be counted', () => {
    const ids = ['moved-a', 'moved-b', ...Array.from({ length: 60 }, (_, i) => `group-${i}`), 'scene-a'];
    const nodes = Object.fromEntries(ids.slice(2, -1).map((id) => [id, node('objects/group')]));
    // Each group contains the two before it.
    const wires = ids.slice(2).flatMap((id, i) => [`${ids[i]}.objects -> ${id}.objects`, `${ids[i + 1]}.objects -> ${id}.objects`]);
    expect(isInMaterials(filteredScene({ effects: [SEPIA], nodes, wires }))).toBe(true);
  });

  test('that pulses change', () => {
    const flash = own('vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(flash ? vec3(1.0) : c.rgb, c.a);').replace(
      '"TYPE": "image" }',
      '"TYPE": "image" }, { "NAME": "flash", "TYPE": "event" }',
    );
    const tap = { nodes: { 'tap-a': node('input/tap') }, wires: ['tap-a.tapped -> e-0.flash'] };
    const pair = filteredScene({ effects: [['filter/flash']], sources: { 'flash.fs': flash }, ...tap });
    expect(isInMaterials(pair)).toBe(true);
    expect(pair.fused.operations.find(({ kind }) => kind === 'draw')?.reads).toContain('tap-a.tapped');
    expect(programFaults(pair.fused)).toEqual([]);
  });

  test('and errors point to the author’s line, by a pass that is only compiled', () => {
    const text = own('\n\n  vec4 c = IMG_THIS_PIXEL(inputImage);\n  gl_FragColor = vec4(c.bgr, c.a);\n');
    const pair = filteredScene({ effects: [SEPIA, ['filter/swap']], sources: { 'swap.fs': text } });
    const [effects] = effectsOf(pair);
    const { fragment = '', sourceMap } = pair.fused.shaders[effects?.trial ?? -1] ?? {};
    const line = fragment.split('\n').findIndex((printed) => printed.includes('.bgr'));
    const [source = -1, at] = sourceMap?.lines[line] ?? [];
    expect([sourceMap?.nodes[source], sourceMap?.sources[source], at]).toEqual(['e-1', 'shaders/swap.fs', 5]);
    const exported = filteredScene({ effects: [SEPIA], options: { sourceMaps: false } });
    expect(effectsOf(exported)[0]?.trial).toBeNull();
    expect(exported.fused.shaders).toEqual([]);
  });

  test('and a page rests unless one of them depends on the clock', () => {
    expect(mayRest(filteredScene({ effects: [SEPIA] }).fused)).toBe(true);
    expect(mayRest(filteredScene({ effects: [['filter/white-balance']] }).fused)).toBe(false);
  });

  test('and `scrim plan` says so', () => {
    expect(describeProgram(filteredScene({ effects: [SEPIA, GRAY] }).fused)).toContain(
      ', with the effects e-0, e-1 in its materials (layer/scene)',
    );
  });
});

describe('a layer of objects stays a texture', () => {
  const found = new Set<SeparateReason>();

  function expectReason(scene: FilteredScene, reason: SeparateReason, wire = 'scene-a.layer'): void {
    const pair = filteredScene(scene);
    expect(pair.wires.find(({ resource }) => resource === wire)?.reason).toBe(reason);
    expect(effectsOf(pair)).toEqual([]);
    found.add(reason);
  }

  test('with antialiasing: an effect is not the same before and after the mean of samples', () => {
    expectReason({ effects: [SEPIA], antialias: true }, 'samples');
    const { wires } = filteredScene({ effects: [SEPIA], antialias: true });
    expect(describeSeparate(wires)).toContain('scene-a.layer → e-0.pass0: objects are drawn into it with several samples per pixel');
  });

  const colored = (color: unknown) => ({ nodes: { 'ball-a': node('objects/primitive', { shape: 'sphere', color }) } });

  test('where objects are transparent or may become so', () => {
    expectReason({ effects: [SEPIA], ...colored([1, 0, 0, 0.5]) }, 'transparent');
    expectReason({ effects: [SEPIA], ...colored({ expression: '[1, 0, 0, 0.5 + 0.5 * sin(time)]' }) }, 'transparent');
    const wired = { nodes: { 'tint-a': node('value/rgb-color') }, wires: ['tint-a.color -> ball-a.color'] };
    expectReason({ effects: [SEPIA], ...wired }, 'transparent');
    const hands = { nodes: { 'hands-a': node('objects/hands') }, wires: ['hands-a.objects -> scene-a.objects'] };
    expectReason({ effects: [SEPIA], ...hands }, 'transparent');
  });

  test('where a panorama may be visible behind the objects', () => {
    const panorama = (visible: boolean): FilteredScene => ({
      effects: [SEPIA],
      nodes: { 'sky-a': node('source/panorama'), 'around-a': node('light/environment', { visible }) },
      wires: ['sky-a.environment -> around-a.environment', 'around-a.lights -> scene-a.lights'],
    });
    expectReason(panorama(true), 'transparent');
    expect(isInMaterials(filteredScene(panorama(false)))).toBe(true);
  });

  test('where an occlusion has a soft border', () => {
    expectReason({ effects: [SEPIA], occlusion: { softnessM: 0.1 } }, 'transparent', 'hide-a.layer');
    expectReason({ effects: [SEPIA], occlusion: { borderPx: 4 } }, 'transparent', 'hide-a.layer');
  });

  test('where its reader colors pixels without objects, or discards pixels', () => {
    expectReason(
      { effects: [['filter/fill']], sources: { 'fill.fs': own('gl_FragColor = vec4(1.0 - IMG_THIS_PIXEL(inputImage).rgb, 1.0);') } },
      'background',
    );
    const discards = own('vec4 c = IMG_THIS_PIXEL(inputImage); if (c.r > 0.5) discard; gl_FragColor = c;');
    expectReason({ effects: [['filter/holes']], sources: { 'holes.fs': discards } }, 'background');
  });

  test('where its reader needs more tables than every device has textures for', () => {
    expect(isInMaterials(filteredScene({ effects: [['filter/curves']] }))).toBe(true);
    expectReason({ effects: [['filter/curves'], ['filter/curves']] }, 'limits');
  });

  test.each([
    'gl_FragCoord.x / 300.0',
    'isf_FragNormCoord.x',
    'RENDERSIZE.x / 900.0',
    'IMG_SIZE(inputImage).x / 900.0',
    'dFdx(c.r)',
    'float(gl_FrontFacing)',
    'gl_PointCoord.x',
  ])('where its reader computes with %s', (value) => {
    const text = own(`vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(c.rgb * ${value}, c.a);`);
    const reason = value.startsWith('dFdx') ? 'elsewhere' : 'position';
    expectReason({ effects: [['filter/placed']], sources: { 'placed.fs': text } }, reason);
  });

  test('where its reader reads another image too', () => {
    const mixed = {
      nodes: { 'pattern-a': { type: 'generator/pattern', version: 1, unfused: true }, 'mix-a': node('operator/blend') },
      wires: ['pattern-a.layer -> mix-a.bottom', 'e-0.layer -> mix-a.top'],
      shown: 'mix-a.layer',
    };
    const pair = filteredScene({ effects: [SEPIA], ...mixed });
    expect(pair.wires.find(({ resource }) => resource === 'scene-a.layer')?.reason).toBe('textures');
    found.add('textures');
  });

  test('where its reader reads other pixels, turns rounding into large steps, or reads depth', () => {
    expectReason({ effects: [['filter/gaussian-blur']] }, 'elsewhere');
    expectReason({ effects: [['filter/threshold']] }, 'unstable');
    expectReason({ effects: [['filter/fog']] }, 'textures');
  });

  test('where something else reads it', () => {
    expectReason({ effects: [SEPIA], options: { taps: ['scene-a.layer'] } }, 'viewed');
    expectReason({ effects: [SEPIA], nodes: { 'scene-a': node('layer/scene', {}, { unfused: true }) } }, 'switched');
    expectReason({ effects: [SEPIA], nodes: { 'e-0': node('filter/sepia', {}, { unfused: true }) } }, 'switched');
  });

  test('where no materials of the objects draw it', () => {
    const mask = {
      nodes: { 'mask-a': node('layer/object-mask'), 'on-a': node('filter/sepia') },
      wires: ['moved-a.objects -> mask-a.objects', 'mask-a.layer -> on-a.inputImage'],
      shown: 'on-a.layer',
    };
    expectReason({ effects: [], ...mask }, 'objects', 'mask-a.layer');
  });

  test('for no other reason of its own', () => {
    const known: readonly SeparateReason[] = ['elsewhere', 'limits', 'unstable', 'viewed', 'switched'];
    expect([...found].filter((reason) => !known.includes(reason)).sort()).toEqual(OBJECT_REASONS);
  });
});
