import { describe, expect, test } from '@jest/globals';
import { EMPTY_LAYOUT } from '../../export/graph/new-project.ts';
import type { Graph, GraphLayout } from '../../export/graph/project.ts';
import { LIBRARY } from '../../tests/support/library.ts';
import { THUMBNAIL_HEIGHT } from '../state/graph/node-shape.ts';
import { detailOf } from './detail.ts';
import { createOverviewPaths } from './overview-paths.ts';
import { type CanvasInput, createCanvasProjection } from './project-canvas.ts';

const GRAPH: Graph = {
  nodes: {
    'video-aaaa': { type: 'source/camera-video', version: 1, params: {} },
    'blur-aaaa': { type: 'filter/gaussian-blur', version: 1, params: {} },
    'math-aaaa': { type: 'value/math', version: 1, params: { a: { value: 2 } } },
    'what-aaaa': { type: 'filter/from-the-future', version: 1, params: {} },
  },
  wires: [
    { from: { node: 'video-aaaa', port: 'layer' }, to: { node: 'blur-aaaa', port: 'inputImage' } },
    { from: { node: 'math-aaaa', port: 'result' }, to: { node: 'blur-aaaa', port: 'radius' } },
    { from: { node: 'blur-aaaa', port: 'layer' }, to: { node: 'what-aaaa', port: 'mystery' } },
  ],
  exposed: { inputs: [], outputs: [] },
};
const LAYOUT: GraphLayout = { ...EMPTY_LAYOUT, nodes: { 'video-aaaa': { x: 0, y: 0 }, 'blur-aaaa': { x: 300, y: 0 } } };
const INPUT: CanvasInput = {
  graph: GRAPH,
  layout: LAYOUT,
  library: LIBRARY,
  selectedNodes: new Set(),
  selectedWires: new Set(),
  expanded: new Set(),
  dragged: {},
  problems: new Map(),
};

const byId = <T extends { id: string }>(list: readonly T[], id: string): T => {
  const found = list.find((item) => item.id === id);
  if (!found) throw new Error(`There is no ${id}.`);
  return found;
};

describe('the canvas as data', () => {
  test('wired params are ports, others only when asked for; nodes that compute show their operands', () => {
    const project = createCanvasProjection();
    const ports = (id: string, input = INPUT) => byId(project(input).nodes, id).data.shape.ports.map(({ name }) => name);
    expect(ports('blur-aaaa')).toEqual(['inputImage', 'layer', 'radius']);
    expect(ports('math-aaaa')).toEqual(['result', 'a', 'b']);
    const unwired = { ...INPUT, graph: { ...GRAPH, wires: [] } };
    expect(ports('blur-aaaa', unwired)).toEqual(['inputImage', 'layer']);
    expect(byId(project(unwired).nodes, 'blur-aaaa').data.shape.hiddenParams).toBe(1);
    expect(ports('blur-aaaa', { ...unwired, expanded: new Set(['blur-aaaa']) })).toEqual(['inputImage', 'layer', 'radius']);
    expect(byId(project(INPUT).nodes, 'math-aaaa').data.values).toEqual({ a: '2', b: '1' });
  });

  test('a node of an unknown type keeps the ports that its wires name', () => {
    const node = byId(createCanvasProjection()(INPUT).nodes, 'what-aaaa');
    expect(node.data.known).toBe(false);
    expect(node.data.title).toBe('filter/from-the-future');
    expect(node.data.shape.ports.map(({ name, side }) => `${side} ${name}`)).toEqual(['input mystery']);
  });

  test('a source is named by its file, and by its type while it has none', () => {
    const nodes = { 'model-aaaa': { type: 'source/model', version: 1, params: { model: { value: 'fox' } } } };
    const input = { ...INPUT, graph: { ...GRAPH, nodes, wires: [] } };
    const [without] = createCanvasProjection()(input).nodes;
    expect(without?.data.title).toBe('Model');
    const assets = { fox: { path: 'assets/fox.glb', kind: 'model' as const } };
    const [node] = createCanvasProjection()({ ...input, assets }).nodes;
    expect(node?.data.title).toBe('fox.glb');
    expect(node?.ariaLabel).toBe('Model, fox.glb');
    const captures = { 'place-aaaa': { type: 'source/capture', version: 1, params: { file: { value: 'kitchen' } } } };
    const more = { kitchen: { path: 'assets/kitchen.capture/capture.json', kind: 'capture' as const } };
    const [place] = createCanvasProjection()({ ...input, graph: { ...GRAPH, nodes: captures, wires: [] }, assets: more }).nodes;
    expect(place?.data.title).toBe('kitchen');
  });

  test('thumbnails take the free space below their nodes', () => {
    const close = { ...LAYOUT, nodes: { 'video-aaaa': { x: 0, y: 0 }, 'blur-aaaa': { x: 100, y: 140 } } };
    const nodes = (layout: GraphLayout) => createCanvasProjection()({ ...INPUT, layout, hasThumbnail: true }).nodes;
    expect(byId(nodes(LAYOUT), 'video-aaaa').data.shape.thumbnail).toEqual({ port: 'layer', height: THUMBNAIL_HEIGHT });
    const squeezed = byId(nodes(close), 'video-aaaa');
    expect(squeezed.position.y + (squeezed.height ?? 0)).toBe(128);
  });

  test('a drag replaces only the dragged node, and keeps its data', () => {
    const project = createCanvasProjection();
    const before = project(INPUT);
    const after = project({ ...INPUT, dragged: { 'blur-aaaa': { x: 310, y: 20 } } });
    for (const id of ['video-aaaa', 'math-aaaa', 'what-aaaa']) expect(byId(after.nodes, id)).toBe(byId(before.nodes, id));
    const moved = byId(after.nodes, 'blur-aaaa');
    expect(moved.position).toEqual({ x: 310, y: 20 });
    expect(moved.data).toBe(byId(before.nodes, 'blur-aaaa').data);
    expect(after.wires).toBe(before.wires);
  });

  test('the handles for React Flow lie on the rim of the node, on their rows', () => {
    const node = byId(createCanvasProjection()(INPUT).nodes, 'blur-aaaa');
    for (const handle of node.handles ?? []) {
      const centerX = handle.x + (handle.width ?? 0) / 2;
      expect(centerX).toBe(handle.type === 'target' ? 0 : node.width);
      expect(handle.y).toBeGreaterThan(0);
      expect(handle.y + (handle.height ?? 0)).toBeLessThanOrEqual(node.height ?? 0);
    }
  });

  test('several wires of one port are numbered in their order; one alone is not', () => {
    const wires = ['a-aaaa', 'b-aaaa'].map((node) => ({
      from: { node, port: 'objects' },
      to: { node: 'scene-aaaa', port: 'objects' },
    }));
    const graph: Graph = {
      ...GRAPH,
      nodes: {
        'a-aaaa': { type: 'objects/primitive', version: 1, params: {} },
        'b-aaaa': { type: 'objects/primitive', version: 1, params: {} },
        'scene-aaaa': { type: 'layer/scene', version: 1, params: {} },
      },
      wires,
    };
    const project = createCanvasProjection();
    expect(project({ ...INPUT, graph }).wires.map(({ data }) => data?.order)).toEqual([1, 2]);
    expect(project({ ...INPUT, graph: { ...graph, wires: wires.slice(0, 1) } }).wires.map(({ data }) => data?.order)).toEqual([null]);
  });

  test('from afar each wire is drawn between its ports, in the path of its color, and follows a drag', () => {
    const project = createCanvasProjection();
    const pathsOf = createOverviewPaths();
    const paths = (input: CanvasInput) => {
      const { nodes, wires } = project(input);
      return pathsOf(nodes, wires);
    };
    const before = paths(INPUT);
    expect([...before.keys()]).toEqual(['layer', 'number']);
    // The only output of the video is on the first row: 30 + 6 + 11 below the top, at the right edge.
    expect(before.get('layer')).toMatch(/^M184,47 C.* 300,47/);
    const after = paths({ ...INPUT, dragged: { 'blur-aaaa': { x: 310, y: 20 } } });
    expect(after.get('layer')).toMatch(/^M184,47 C.* 310,67M/);
    expect(after.get('layer')?.match(/M/g)).toHaveLength(2);
  });

  test('only large graphs are drawn as patches, and only where nothing can be read', () => {
    expect([detailOf(0.2, 1000), detailOf(0.2, 20), detailOf(0.5, 1000)]).toEqual(['overview', 'heads', 'whole']);
  });
});
