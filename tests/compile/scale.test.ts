import { describe, expect, test } from '@jest/globals';
import { compile, createCompiler } from '../../export/compiler/compile.ts';
import type { Graph, GraphNode, ProjectLogic } from '../../export/graph/project.ts';
import { sortWires } from '../../export/graph/wires.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { TEST_LIBRARY as library } from '../support/test-library.ts';
import { wireOf } from '../support/test-studio.ts';
import { programFaults } from './program-faults.ts';

function projectOf(
  types: Readonly<Record<string, string>>,
  wires: readonly string[],
  graphs: Readonly<Record<string, Graph>> = {},
): ProjectLogic {
  const nodes = Object.fromEntries(Object.entries(types).map(([id, type]): [string, GraphNode] => [id, { type, version: 1, params: {} }]));
  const main: Graph = { nodes, wires: sortWires(wires.map(wireOf)), exposed: { inputs: [], outputs: [] } };
  return { title: '', page: { description: '', language: 'en' }, graphs: { ...graphs, main }, sources: {}, assets: {} };
}

const range = (count: number) => Array.from({ length: count }, (_, i) => i);

/** video → filter → filter → … → screen. */
function chain(count: number, types: readonly string[] = ['filter/sepia', 'filter/gaussian-blur', 'filter/swirl']): ProjectLogic {
  const nodes = Object.fromEntries(range(count).map((i) => [`f-${i}`, types[i % types.length] ?? '']));
  const wires = range(count - 1).map((i) => `f-${i}.layer -> f-${i + 1}.inputImage`);
  return projectOf({ ...nodes, 'video-a': 'source/camera-video', 'screen-a': 'output/screen' }, [
    ...wires,
    'video-a.layer -> f-0.inputImage',
    `f-${count - 1}.layer -> screen-a.layer`,
  ]);
}

/** Scenes laid over each other one by one, with something at the end that makes all of them pictures. */
function stackOfScenes(count: number, end: string): ProjectLogic {
  const nodes = Object.fromEntries(
    range(count).flatMap((i) => [
      [`s-${i}`, 'layer/scene'],
      [`o-${i}`, 'operator/over'],
    ]),
  );
  const wires = range(count).flatMap((i) => [
    `box-a.objects -> s-${i}.objects`,
    `s-${i}.layer -> o-${i}.top`,
    i === 0 ? 'video-a.layer -> o-0.bottom' : `o-${i - 1}.layer -> o-${i}.bottom`,
  ]);
  return projectOf(
    { ...nodes, 'box-a': 'objects/primitive', 'end-a': end, 'video-a': 'source/camera-video', 'screen-a': 'output/screen' },
    [...wires, `o-${count - 1}.layer -> end-a.inputImage`, 'end-a.layer -> screen-a.layer'],
  );
}

function compiled(project: ProjectLogic, taps: readonly string[] = []) {
  const { output, diagnostics } = compile({ project, library, options: { taps } });
  if (output === null) throw new Error(diagnostics.slice(0, 3).map(formatDiagnostic).join('\n'));
  return output;
}

/** How often a compile asks the library what a node is: what it does per node, but for a constant. */
function questions(project: ProjectLogic): number {
  let count = 0;
  const counting: NodeLibrary = {
    ...library,
    definition: (type) => {
      count++;
      return library.definition(type);
    },
  };
  expect(compile({ project, library: counting }).output).not.toBeNull();
  return count;
}

/** A chain of filters, each with a number of its own wired to it. */
function chainWithValues(count: number): ProjectLogic {
  const { graphs, ...rest } = chain(count, ['filter/sepia']);
  const main = graphs.main as Graph;
  const values = range(count).map((i): [string, GraphNode] => [`n-${i}`, { type: 'value/number', version: 1, params: {} }]);
  const wires = range(count).map((i) => wireOf(`n-${i}.value -> f-${i}.amount`));
  return {
    ...rest,
    graphs: { main: { ...main, nodes: { ...main.nodes, ...Object.fromEntries(values) }, wires: sortWires([...main.wires, ...wires]) } },
  };
}

describe('large graphs', () => {
  test('5,000 live image operations compile, with as much work for each as in a small graph', () => {
    // Times are for `npm run bench`: a busy machine would make them fail here.
    expect(questions(chain(5000)) / 5000).toBeLessThanOrEqual((questions(chain(500)) / 500) * 1.1);
    const program = compiled(chain(5000));
    expect(program.operations.filter(({ kind }) => kind === 'pass').length).toBeGreaterThanOrEqual(5000);
    expect(program.shaders.length).toBeLessThan(10);
    expect(programFaults(program)).toEqual([]);
  });

  test('10,000 nodes that all do something compile', () => {
    const program = compiled(chainWithValues(5000));
    expect(program.operations.filter(({ kind }) => kind === 'value')).toHaveLength(5000);
    expect(program.operations.filter(({ kind }) => kind === 'pass')).toHaveLength(5000);
    expect(programFaults(program)).toEqual([]);
  });

  test('10,000 nodes, most of which do nothing, compile', () => {
    const dead = Object.fromEntries(range(9000).map((i) => [`d-${i}`, 'value/math']));
    const live = chain(1000);
    const nodes = {
      ...live.graphs.main?.nodes,
      ...Object.fromEntries(Object.keys(dead).map((id) => [id, { type: 'value/math', version: 1, params: {} }])),
    };
    const project = { ...live, graphs: { main: { ...(live.graphs.main as Graph), nodes } } };
    expect(compiled(project).operations.length).toBe(compiled(live).operations.length);
  });

  test('a stack of 2,000 merged scenes of which the depth is read, all looked at, overflows nothing', () => {
    const project = stackOfScenes(2000, 'filter/fog');
    const program = compiled(
      project,
      range(2000).map((i) => `o-${i}.layer`),
    );
    expect(program.resources.filter(({ id }) => id.endsWith('.layer.depth'))).toHaveLength(2000);
    expect(programFaults(program)).toEqual([]);
  });

  test('2,000 scenes without anything in between go straight onto the screen', () => {
    const { graphs, ...rest } = stackOfScenes(2000, 'filter/sepia');
    const main = graphs.main as Graph;
    const muted = {
      ...rest,
      graphs: { main: { ...main, nodes: { ...main.nodes, 'end-a': { type: 'filter/sepia', version: 1, params: {}, muted: true } } } },
    };
    const program = compiled(muted);
    expect(program.presentation.mode).toBe('forward');
    expect(program.operations).toHaveLength(2001);
  });

  test('20,000 values in a chain compile', () => {
    const nodes = Object.fromEntries(range(20_000).map((i) => [`n-${i}`, 'value/math']));
    const wires = range(19_999).map((i) => `n-${i}.result -> n-${i + 1}.a`);
    const project = projectOf({ ...nodes, 'f-a': 'filter/sepia', 'video-a': 'source/camera-video', 'screen-a': 'output/screen' }, [
      ...wires,
      'n-19999.result -> f-a.amount',
      'video-a.layer -> f-a.inputImage',
      'f-a.layer -> screen-a.layer',
    ]);
    expect(compiled(project).operations.filter(({ kind }) => kind === 'value')).toHaveLength(20_000);
  });

  test('subgraphs that make too many nodes of a small file are refused before they do, with the limit', () => {
    const exposed = {
      inputs: [{ name: 'inputImage', node: 'a-a', port: 'inputImage' }],
      outputs: [{ name: 'layer', node: 'b-a', port: 'layer' }],
    };
    const twice = (type: string): Graph => ({
      nodes: { 'a-a': { type, version: 1, params: {} }, 'b-a': { type, version: 1, params: {} } },
      wires: [wireOf('a-a.layer -> b-a.inputImage')],
      exposed,
    });
    const project = (depth: number) =>
      projectOf(
        { 'deep-a': `graph/g${depth - 1}`, 'video-a': 'source/camera-video', 'screen-a': 'output/screen' },
        ['video-a.layer -> deep-a.inputImage', 'deep-a.layer -> screen-a.layer'],
        Object.fromEntries(range(depth).map((i) => [`g${i}`, twice(i === 0 ? 'filter/sepia' : `graph/g${i - 1}`)])),
      );
    expect(compiled(project(10)).operations.length).toBeGreaterThanOrEqual(1024);
    for (const depth of [16, 60]) {
      const { output, diagnostics } = compile({ project: project(depth), library });
      expect(output).toBeNull();
      expect(diagnostics.map(formatDiagnostic).join('\n')).toContain('SCR026');
      expect(diagnostics[0]?.message).toContain('more than 40,000 nodes');
    }
  });

  test('2,000 muted nodes in a chain are bypassed', () => {
    const project = chain(2000);
    const nodes = Object.fromEntries(
      Object.entries((project.graphs.main as Graph).nodes).map(([id, node]) => [id, id.startsWith('f-') ? { ...node, muted: true } : node]),
    );
    expect(compiled({ ...project, graphs: { main: { ...(project.graphs.main as Graph), nodes } } }).operations).toEqual([]);
  });

  test('subgraphs nested 1,000 deep are inlined', () => {
    const exposed = (node: string) => ({
      inputs: [{ name: 'picture', node, port: node === 'sepia-a' ? 'inputImage' : 'picture' }],
      outputs: [{ name: 'layer', node, port: 'layer' }],
    });
    const graph = (id: string, type: string): Graph => ({
      nodes: { [id]: { type, version: 1, params: {} } },
      wires: [],
      exposed: exposed(id),
    });
    const graphs = Object.fromEntries(
      range(1000).map((i) => [`g${i}`, i === 0 ? graph('sepia-a', 'filter/sepia') : graph('in-a', `graph/g${i - 1}`)]),
    );
    const project = projectOf(
      { 'deep-a': 'graph/g999', 'video-a': 'source/camera-video', 'screen-a': 'output/screen' },
      ['video-a.layer -> deep-a.picture', 'deep-a.layer -> screen-a.layer'],
      graphs,
    );
    expect(compiled(project).operations.at(-1)?.node).toBe(`deep-a/${'in-a/'.repeat(999)}sepia-a`);
  });

  test('an edit compiles without reading the shaders again', () => {
    const { compile: again } = createCompiler();
    const project = chain(20);
    const maps = (edited: ProjectLogic) => again({ project: edited, library }).output?.shaders.map(({ sourceMap }) => sourceMap?.lines);
    const first = maps(project);
    const second = maps({ ...project, graphs: { main: { ...(project.graphs.main as Graph) } } });
    expect(first).toHaveLength(4);
    // Earlier results are reused, not created again.
    for (const [i, lines] of (second ?? []).entries()) expect(lines).toBe(first?.[i]);
  });
});
