import { describe, expect, test } from '@jest/globals';
import { DEFINITIONS } from '../../../nodes/generated/definitions.gen.ts';
import { categoryLabel } from '../../../nodes/kit/categories.ts';
import { defineNode, type NodeDefinition } from '../../../nodes/kit/definition.ts';
import type { OpenEnd } from '../editor/canvas-state.ts';
import { listPalette, searchPalette } from './palette-search.ts';

const titles = (query: string, end: OpenEnd | null = null) =>
  searchPalette(DEFINITIONS, query, end).map(({ definition }) => definition.title);

function node(type: string, title: string, more: Partial<NodeDefinition> = {}): NodeDefinition {
  return defineNode({ type, version: 1, title, doc: '', inputs: {}, outputs: {}, params: {}, lowering: { kind: 'value' }, ...more });
}

describe('searching for node types', () => {
  test('finds by title, by other words, by name and by letters in order', () => {
    expect(titles('sepia')[0]).toBe('Sepia');
    expect(titles('occlude')).toContain('Depth occlusion');
    // The plainest first.
    expect(titles('blur').slice(0, 3)).toEqual(['Gaussian blur', 'Spin blur', 'Zoom blur']);
    expect(titles('gsnblr')).toEqual(['Gaussian blur']);
    expect(titles('xyzzy')).toEqual([]);
  });

  test('the start of a title beats a word in it, which beats a keyword, which beats the category', () => {
    const nodes = [
      node('glow/a', 'Alpha'),
      node('x/b', 'Beta', { keywords: ['glow'] }),
      node('x/c', 'Soft glow'),
      node('x/d', 'Glow'),
      node('x/e', 'Glowing edges'),
    ];
    expect(searchPalette(nodes, 'glow', null).map(({ definition }) => definition.type)).toEqual(['x/d', 'x/e', 'x/c', 'x/b', 'glow/a']);
  });

  test.each([
    ['webcam', 'Camera video'],
    ['defocus', 'Depth of field'],
    ['greenscreen', 'Chroma key'],
    ['gray', 'Grayscale'],
    ['grey', 'Grayscale'],
    ['color', 'Color'],
    ['colour', 'Color'],
    ['color correction', 'Color temperature'],
    ['viewer', 'Output'],
    ['screen', 'Output'],
    ['composite', 'Alpha over'],
    ['technique', 'Set material'],
    ['radial blur', 'Zoom blur'],
    ['color table', 'LUT'],
    ['colour correction', 'Color temperature'],
    ['lfo', 'Expression'],
    ['mask', 'Mask'],
    ['gaze', 'Head pose'],
    ['billboard', 'Look at'],
    ['attach', 'Place at pose'],
    ['orbit', 'Orbit pose'],
    ['distance', 'Distance'],
    ['proximity', 'Distance'],
  ])('%s is %s to people who come from elsewhere', (query, title) => {
    expect(titles(query)[0]).toBe(title);
  });

  test('a trigger is also a zone that somebody enters', () => {
    expect(titles('trigger').slice(0, 5)).toContain('Inside box');
    expect(titles('trigger volume')).toEqual(['Inside box']);
    expect(titles('trigger zone')).toEqual(['Inside box']);
  });

  test('letters in the middle of words find nothing by chance', () => {
    // “Halftone” and “Flip-flop” have these letters in this order, but do not begin with the first.
    expect(titles('lfo')).toEqual(['Expression', 'Lights from panorama']);
    expect(titles('face')).not.toContain('Light estimation');
  });

  test('every word has to match', () => {
    expect(titles('color temp')[0]).toBe('Color temperature');
    expect(titles('sepia blur')).toEqual([]);
  });

  test('without words, all of them by category', () => {
    const all = searchPalette(DEFINITIONS, '', null).map(({ definition }) => definition.type);
    expect(all).toHaveLength(DEFINITIONS.length);
    const categories = all.map(categoryLabel);
    expect([...categories].sort()).toEqual(categories);
  });

  test('with a wire in hand, only what has a port for it, and which', () => {
    const entries = searchPalette(DEFINITIONS, '', { type: 'depth', side: 'output' });
    expect(entries.map(({ definition, port }) => `${definition.type}.${port}`)).toContain('layer/depth-occlusion.depth');
    expect(entries.every(({ definition, port }) => port !== null && definition.inputs[port]?.type === 'depth')).toBe(true);
    expect(titles('', { type: 'layer', side: 'input' })).toContain('Camera video');
    expect(titles('', { type: 'layer', side: 'input' })).not.toContain('Output');
  });

  test('a port of the very type is taken before one that converts', () => {
    const both = node('x/y', 'Both', {
      params: {
        n: { type: 'number', stage: 'uniform', label: '', doc: '', default: 0 },
        t: { type: 'toggle', stage: 'uniform', label: '', doc: '', default: false },
      },
    });
    expect(searchPalette([both], '', { type: 'toggle', side: 'output' })[0]?.port).toBe('t');
    const numberOnly = node('x/z', 'Number only', { params: { n: { type: 'number', stage: 'uniform', label: '', doc: '', default: 0 } } });
    expect(searchPalette([numberOnly], '', { type: 'toggle', side: 'output' })[0]?.port).toBe('n');
  });
});

test('favorites come first, then what was added last, then all by category; a search finds each once', () => {
  const listed = (query: string, favorites: readonly string[], recent: readonly string[]) =>
    listPalette(searchPalette(DEFINITIONS, query, null), query, favorites, recent).map(
      ({ section, definition }) => `${section}: ${definition.type}`,
    );
  const all = listed('', [], []);
  expect(listed('', ['filter/sepia', 'filter/none'], ['value/number', 'filter/sepia'])).toEqual([
    'Favorites: filter/sepia',
    'Recent: value/number',
    ...all,
  ]);
  expect(listed('sepia', ['filter/sepia'], [])).toEqual(listed('sepia', [], []));
});

test('the category that was asked for comes before favorites and all others, each type once', () => {
  const entries = searchPalette(DEFINITIONS, '', null);
  const listed = listPalette(entries, '', ['operator/over'], [], 'filter');
  const sections = listed.map(({ section }) => section).filter((section, i, all) => section !== all[i - 1]);
  expect(sections.slice(0, 2)).toEqual(['filter', 'Favorites']);
  expect(sections.filter((section) => section === 'filter')).toHaveLength(1);
  expect(listed).toHaveLength(entries.length + 1);
});
