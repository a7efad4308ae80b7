import { expect, test } from '@jest/globals';
import { EMPTY_GRAPH, EMPTY_LAYOUT } from './new-project.ts';
import { placeNodes } from './place-nodes.ts';
import type { Graph } from './project.ts';
import { parseWire } from './wires.ts';

function chain(...ids: string[]): Graph {
  const nodes = Object.fromEntries(ids.map((id) => [id, { type: 'filter/sepia', version: 1, params: {} }]));
  const wires = ids.slice(1).flatMap((id, i) => parseWire(`${ids[i]}.layer -> ${id}.inputImage`) ?? []);
  return { ...EMPTY_GRAPH, nodes, wires };
}

test('without a layout the wires run from left to right, and no two nodes lie on each other', () => {
  const graph = chain('c-a', 'a-a', 'b-a');
  const places = placeNodes({ ...graph, nodes: { ...graph.nodes, 'd-a': { type: 'x/y', version: 1, params: {} } } }, undefined);
  expect([places['c-a']?.x, places['a-a']?.x, places['b-a']?.x]).toEqual([0, 280, 560]);
  expect(new Set(Object.values(places).map(({ x, y }) => `${x} ${y}`)).size).toBe(4);
});

test('what has a place keeps it, and the rest goes below', () => {
  const places = placeNodes(chain('a-a', 'b-a'), { ...EMPTY_LAYOUT, nodes: { 'a-a': { x: 500, y: 70, collapsed: true } } });
  expect(places['a-a']).toEqual({ x: 500, y: 70, collapsed: true });
  expect(places['b-a']).toEqual({ x: 780, y: 250 });
});

/** A layer over the faded previous frame: the loop is entered at `over-a`. */
const TRAIL = ['scene-a.layer -> over-a.top', 'over-a.layer -> before-a.layer', 'before-a.layer -> fade-a.inputImage'];
const BACK = ['fade-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer'];

test('a loop runs from left to right, too, from where it is entered, and one wire goes back', () => {
  const ids = ['before-a', 'fade-a', 'over-a', 'scene-a', 'screen-a'];
  const nodes = Object.fromEntries(ids.map((id) => [id, { type: 'filter/sepia', version: 1, params: {} }]));
  const wires = [...TRAIL, ...BACK].flatMap((wire) => parseWire(wire) ?? []);
  const places = placeNodes({ ...EMPTY_GRAPH, nodes, wires }, undefined);
  const columns = Object.fromEntries(ids.map((id) => [id, (places[id]?.x ?? Number.NaN) / 280]));
  expect(columns).toEqual({ 'scene-a': 0, 'over-a': 1, 'before-a': 2, 'screen-a': 2, 'fade-a': 3 });
});

test('a loop that nothing leads to is placed along itself, however long it is', () => {
  const ids = Array.from({ length: 10_000 }, (_, i) => `n-${String(i).padStart(5, '0')}`);
  const places = placeNodes(chain(...ids, 'n-00000'), undefined);
  expect(ids.map((id) => places[id]?.x)).toEqual(ids.map((_, i) => i * 280));
});
