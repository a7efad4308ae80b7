import { describe, expect, test } from '@jest/globals';
import { describeFolded } from '../../export/compiler/describe.ts';
import { FOLD_REASONS } from '../../export/compiler/fold/folded-node.ts';
import type { Program } from '../../export/program/program.ts';
import { passes, twins } from '../support/fusion-kit.ts';
import { LIBRARY } from '../support/library.ts';
import { draws, ids } from './compiled.ts';

type Nodes = Readonly<Record<string, object>>;

function node(type: string, params: object = {}): object {
  return { type, version: LIBRARY.definition(type)?.version ?? 1, params };
}

/** The program of a page, without fusion, so that each effect is a pass. */
function folded(nodes: Nodes, wires: readonly string[], sources: Readonly<Record<string, string>> = {}): Program {
  return twins(nodes, wires, sources, { fold: true }).separate;
}

/** What a slot of a uniform contains before the first frame. */
function uniformOf({ slots, operations }: Program, pass: string, name: string): number | undefined {
  const operation = operations.find(({ id }) => id === pass);
  const source = operation?.kind === 'pass' ? operation.uniforms.find((uniform) => uniform.name === name)?.source : undefined;
  return source && 'slot' in source ? slots.numbers[slots.slots[source.slot]?.offset ?? -1] : undefined;
}

const FADE_WIRES = ['pattern-a.layer -> grey-a.inputImage', 'grey-a.layer -> screen-a.layer'];

describe('values that never change are constants', () => {
  test('through numbers, mathematics, comparisons and switches', () => {
    const nodes = {
      'two-a': node('value/number', { value: 0.2 }),
      'math-a': node('value/math', { operation: 'multiply', b: 3 }),
      'more-a': node('value/compare', { operation: 'greater', b: 0.5 }),
      'pick-a': node('value/switch-number', { first: 0.1, second: 0.7 }),
      'grey-a': node('filter/grey'),
    };
    const wires = [
      'two-a.number -> math-a.a',
      'math-a.result -> more-a.a',
      'more-a.result -> pick-a.index',
      'pick-a.chosen -> grey-a.amount',
      ...FADE_WIRES,
    ];
    expect(ids(twins(nodes, wires).separate, 'value')).toHaveLength(4);
    const made = folded(nodes, wires);
    expect(ids(made, 'value')).toEqual([]);
    expect(uniformOf(made, 'grey-a.pass0', 'a_amount')).toBe(0.7);
  });

  test('through colors and vectors', () => {
    const nodes = {
      'hsv-a': node('value/hsv-color', { hueRad: 0, saturation: 0.5, brightness: 1 }),
      'mix-a': node('value/mix-color', { b: [0, 0, 0, 1], amount: 0.5, space: 'screen' }),
      'split-a': node('value/split-color'),
      'vector-a': node('value/make-vector2', { y: 0.2 }),
      'parts-a': node('value/split-vector2'),
      'remap-a': node('value/remap', { fromHigh: 0.5, toHigh: 0.8 }),
      'grey-a': node('filter/grey'),
    };
    const wires = [
      'hsv-a.color -> mix-a.a',
      'mix-a.color -> split-a.color',
      'split-a.green -> vector-a.x',
      'vector-a.vector -> parts-a.vector',
      'parts-a.x -> remap-a.number',
      'remap-a.result -> grey-a.amount',
      ...FADE_WIRES,
    ];
    expect(ids(twins(nodes, wires).separate, 'value')).toHaveLength(6);
    const made = folded(nodes, wires);
    expect(ids(made, 'value')).toEqual([]);
    // Green of (1, 0.5, 0.5) mixed evenly with black is 0.25: half of the range to 0.5, so half of 0.8.
    expect(uniformOf(made, 'grey-a.pass0', 'a_amount')).toBeCloseTo(0.4, 6);
  });

  test('as expressions without time, but not with it', () => {
    const fading = (expression: string) => ({ 'grey-a': node('filter/grey', { amount: { expression } }) });
    const still = folded(fading('0.25 + 0.5'), FADE_WIRES);
    expect([ids(still, 'value'), uniformOf(still, 'grey-a.pass0', 'a_amount')]).toEqual([[], 0.75]);
    expect(ids(folded(fading('0.25 + sin(time)'), FADE_WIRES), 'value')).toEqual(['grey-a.amount.expression']);
  });

  test('but not where a control of the page sets them', () => {
    const nodes = {
      'slide-a': node('input/slider'),
      'math-a': node('value/math', { b: 0 }),
      'grey-a': node('filter/grey'),
    };
    const made = folded(nodes, ['slide-a.number -> math-a.a', 'math-a.result -> grey-a.amount', ...FADE_WIRES]);
    expect(ids(made, 'value')).toEqual(['slide-a', 'math-a']);
    expect(made.controls).toHaveLength(1);
  });

  test('and not where a wire exceeds the limits of a param, which typed values do not', () => {
    const nodes = { 'two-a': node('value/number', { value: 2 }), 'grey-a': node('filter/grey') };
    expect(ids(folded(nodes, ['two-a.number -> grey-a.amount', ...FADE_WIRES]), 'value')).toEqual(['two-a']);
  });
});

describe('what is equal is computed once', () => {
  test('of two equal effects on one layer, and of the values of two nodes', () => {
    const moving = { a: { expression: 'time' }, b: 2 };
    const nodes = {
      'one-a': node('value/math', moving),
      'two-a': node('value/math', moving),
      'grey-a': node('filter/grey', { amount: 0.5 }),
      'pale-a': node('filter/grey', { amount: { expression: '1 / 2' } }),
      'sepia-a': node('filter/sepia'),
      'sepia-b': node('filter/sepia'),
      'blend-a': node('operator/blend', { mode: 3 }),
    };
    const wires = [
      'one-a.result -> sepia-a.amount',
      'two-a.result -> sepia-b.amount',
      'pattern-a.layer -> grey-a.inputImage',
      'pattern-a.layer -> pale-a.inputImage',
      'grey-a.layer -> sepia-a.inputImage',
      'pale-a.layer -> sepia-b.inputImage',
      'sepia-a.layer -> blend-a.top',
      'sepia-b.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ];
    const made = folded(nodes, wires);
    expect(ids(made, 'pass')).toEqual(['pattern-a.pass0', 'grey-a.pass0', 'sepia-a.pass0', 'blend-a.pass0']);
    expect(ids(made, 'value')).toEqual(['one-a.a.expression', 'one-a']);
  });

  test('but not of two that differ in a param, or that a visitor may set', () => {
    const nodes = {
      'grey-a': node('filter/grey'),
      'pale-a': node('filter/grey', { amount: 0.5 }),
      'blend-a': node('operator/blend'),
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'pattern-a.layer -> pale-a.inputImage',
      'grey-a.layer -> blend-a.top',
      'pale-a.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ];
    expect(passes(folded(nodes, wires))).toHaveLength(4);
  });
});

describe('what cannot be seen is left out', () => {
  const SCENE = {
    'box-a': node('objects/primitive'),
    'scene-a': node('layer/scene'),
    'video-a': node('source/camera-video'),
  };
  const OVER_WIRES = ['box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'over-a.layer -> screen-a.layer'];

  test('a scene that is put over the camera with an opacity of 0: nothing is drawn, and the page needs no three.js', () => {
    const nodes = { ...SCENE, 'over-a': node('operator/over', { opacity: 0 }) };
    const wires = [...OVER_WIRES, 'video-a.layer -> over-a.bottom'];
    expect(draws(twins(nodes, wires).separate)).toHaveLength(1);
    const made = folded(nodes, wires);
    expect([made.operations, made.needs, made.presentation.background]).toEqual([[], [], 'world']);
  });

  test('but not while a wire, an expression or a control may change the opacity', () => {
    const moved = folded({ ...SCENE, 'over-a': node('operator/over', { opacity: { expression: 'time' } }) }, [
      ...OVER_WIRES,
      'video-a.layer -> over-a.bottom',
    ]);
    expect(draws(moved)).toHaveLength(1);
    const controlled = folded({ ...SCENE, 'slide-a': node('input/slider', { value: 0 }), 'over-a': node('operator/over') }, [
      ...OVER_WIRES,
      'video-a.layer -> over-a.bottom',
      'slide-a.number -> over-a.opacity',
    ]);
    expect(draws(controlled)).toHaveLength(1);
  });

  test('a mask with an amount of 0, and the layer of the mask', () => {
    const nodes = {
      'mask-a': node('operator/mask', { amount: 0 }),
      'sepia-a': node('filter/sepia'),
    };
    const wires = [
      'pattern-a.layer -> mask-a.inputImage',
      'other-a.layer -> mask-a.mask',
      'mask-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> screen-a.layer',
    ];
    expect(ids(folded(nodes, wires), 'pass')).toEqual(['pattern-a.pass0', 'sepia-a.pass0']);
  });

  test('but not an effect of the project, whose header may be wrong about it', () => {
    const own = `/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }, { "NAME": "amount", "TYPE": "float", "DEFAULT": 0.0, "IDENTITY": 0.0 }] }*/
void main() { gl_FragColor = vec4(1.0, amount, 0.0, IMG_THIS_PIXEL(inputImage).a); }`;
    const wires = ['pattern-a.layer -> own-a.inputImage', 'own-a.layer -> screen-a.layer'];
    expect(passes(folded({ 'own-a': node('filter/own') }, wires, { 'own.fs': own }))).toHaveLength(2);
  });

  test('nor one that drops a depth which a later effect would read', () => {
    const nodes = {
      'box-a': SCENE['box-a'],
      'scene-a': SCENE['scene-a'],
      'swirl-a': node('filter/swirl', { angle: 0 }),
      'fog-a': node('filter/fog'),
    };
    const wires = [
      'box-a.objects -> scene-a.objects',
      'scene-a.layer -> swirl-a.inputImage',
      'swirl-a.layer -> fog-a.inputImage',
      'fog-a.layer -> screen-a.layer',
    ];
    expect(ids(folded(nodes, wires), 'pass')).toEqual(['swirl-a.pass0', 'fog-a.pass0']);
  });

  test('nor anything while the editor views layers', () => {
    const nodes = { 'grey-a': node('filter/grey', { amount: 0 }) };
    const { separate } = twins(nodes, FADE_WIRES, {}, { fold: true, taps: ['pattern-a.layer'] });
    expect(ids(separate, 'pass')).toContain('grey-a.pass0');
  });
});

test('each node that is left out is named, with the reason', () => {
  const nodes = {
    'two-a': node('value/number', { value: 0.2 }),
    'math-a': node('value/math', { operation: 'multiply', b: 3 }),
    'gray-a': node('filter/grey'),
    'gray-b': node('filter/grey', { amount: { expression: '0.2 * 3' } }),
    'blend-a': node('operator/blend', { mode: 3 }),
    'mask-a': node('operator/mask', { amount: 0 }),
    'sepia-a': node('filter/sepia'),
  };
  const wires = [
    'two-a.number -> math-a.a',
    'math-a.result -> gray-a.amount',
    'pattern-a.layer -> gray-a.inputImage',
    'pattern-a.layer -> gray-b.inputImage',
    'gray-a.layer -> blend-a.top',
    'gray-b.layer -> blend-a.bottom',
    'blend-a.layer -> mask-a.inputImage',
    'other-a.layer -> sepia-a.inputImage',
    'sepia-a.layer -> mask-a.mask',
    'mask-a.layer -> screen-a.layer',
  ];
  const { folded: left } = twins(nodes, wires, {}, { fold: true });
  const byNode = Object.fromEntries(left.map(({ node: id, reason, instead }) => [id, instead === null ? reason : `${reason}: ${instead}`]));
  const [first, second] = byNode['gray-a'] === undefined ? ['gray-a', 'gray-b'] : ['gray-b', 'gray-a'];
  expect(byNode).toEqual({
    'two-a': 'constant',
    'math-a': 'constant',
    [second]: `equal: ${first}`,
    'mask-a': 'unchanged: blend-a',
    'other-a': 'unread',
    'sepia-a': 'unread',
  });
  expect(new Set(left.map(({ reason }) => reason))).toEqual(new Set(Object.keys(FOLD_REASONS)));
  const said = describeFolded(left);
  expect(said).toContain('mask-a: with its parameters it changes nothing (blend-a)');
  expect(said).toContain('sepia-a: only nodes that are left out need it (unread)');
  expect(describeFolded([])).toBe('');
});
