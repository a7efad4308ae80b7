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

test('loops are placed too', () => {
  const graph = chain('a-a', 'b-a', 'a-a');
  expect(Object.keys(placeNodes(graph, undefined)).sort()).toEqual(['a-a', 'b-a']);
});
