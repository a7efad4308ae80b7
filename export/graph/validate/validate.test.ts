import { describe, expect, test } from '@jest/globals';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { readShader, TEST_LIBRARY } from '../../../tests/support/test-library.ts';
import { TestStudio, wireOf } from '../../../tests/support/test-studio.ts';
import type { Binding, Graph, GraphNode, Project } from '../project.ts';
import { sortWires } from '../wires.ts';
import { validateProject } from './validate.ts';

interface Sketch {
  readonly nodes?: Readonly<Record<string, string | GraphNode>>;
  readonly wires?: readonly string[];
  readonly exposed?: Graph['exposed'];
}

function graphOf({ nodes = {}, wires = [], exposed = { inputs: [], outputs: [] } }: Sketch): Graph {
  const entries = Object.entries(nodes).map(([id, node]) => [id, typeof node === 'string' ? { type: node, version: 1, params: {} } : node]);
  return { nodes: Object.fromEntries(entries), wires: sortWires(wires.map(wireOf)), exposed };
}

/** A whole project of which the document is wrong in ways that no command would make it. */
function projectOf(main: Sketch, more: Partial<Project> & { readonly subgraphs?: Readonly<Record<string, Sketch>> } = {}): Project {
  const { subgraphs = {}, ...rest } = more;
  const graphs = Object.fromEntries(Object.entries({ main, ...subgraphs }).map(([name, sketch]) => [name, graphOf(sketch)]));
  return { title: '', page: { description: '', language: 'en' }, layout: {}, sources: {}, assets: {}, ...rest, graphs };
}

const validate = (project: Project) => validateProject(project, TEST_LIBRARY);
const codes = (project: Project) =>
  validate(project).map(({ severity, code, nodeId, port }) => [severity, code, nodeId, port].filter(Boolean).join(' '));

const VIDEO_TO_SCREEN: Sketch = {
  nodes: { 'video-aaaa': 'source/camera-video', 'screen-aaaa': 'output/screen' },
  wires: ['video-aaaa.layer -> screen-aaaa.layer'],
};

const withParams = (type: string, params: Record<string, Binding>): Sketch => ({
  nodes: { ...VIDEO_TO_SCREEN.nodes, 'node-aaaa': { type, version: 1, params } },
  wires: VIDEO_TO_SCREEN.wires ?? [],
});

describe('validateProject', () => {
  test('has nothing to say of a whole graph', () => {
    expect(validate(projectOf(VIDEO_TO_SCREEN))).toEqual([]);
  });

  test.each<[string, Project, string[]]>([
    ['no screen', projectOf({ nodes: { 'video-aaaa': 'source/camera-video' } }), ['error SCR017']],
    [
      'two screens',
      projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'screen-bbbb': 'output/screen' } }),
      ['error SCR017 screen-bbbb', 'error SCR015 screen-bbbb layer'],
    ],
    [
      'an unknown node type',
      projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'x-aaaa': 'filter/nothing' } }),
      ['error SCR010 x-aaaa'],
    ],
    [
      'a node of a newer version',
      projectOf({
        ...VIDEO_TO_SCREEN,
        nodes: { ...VIDEO_TO_SCREEN.nodes, 'x-aaaa': { type: 'filter/sepia', version: 2, params: { new: { value: 1 } } } },
      }),
      ['error SCR011 x-aaaa', 'warning SCR015 x-aaaa inputImage'],
    ],
    [
      'a wire from nowhere',
      projectOf({ nodes: { 'screen-aaaa': 'output/screen' }, wires: ['video-aaaa.layer -> screen-aaaa.layer'] }),
      ['error SCR012 video-aaaa layer'],
    ],
    [
      'a wire between types',
      projectOf({
        nodes: { 'model-aaaa': 'source/model', 'screen-aaaa': 'output/screen' },
        wires: ['model-aaaa.objects -> screen-aaaa.layer'],
      }),
      ['error SCR013 screen-aaaa layer', 'warning SCR030 model-aaaa model'],
    ],
    [
      'a loop',
      projectOf({
        nodes: { 'a-aaaa': 'filter/sepia', 'b-aaaa': 'filter/sepia', 'screen-aaaa': 'output/screen' },
        wires: ['a-aaaa.layer -> b-aaaa.inputImage', 'b-aaaa.layer -> a-aaaa.inputImage', 'b-aaaa.layer -> screen-aaaa.layer'],
      }),
      ['error SCR014 a-aaaa'],
    ],
    [
      'a required port without a wire, on the way to the screen',
      projectOf({ nodes: { 'a-aaaa': 'filter/sepia', 'screen-aaaa': 'output/screen' }, wires: ['a-aaaa.layer -> screen-aaaa.layer'] }),
      ['error SCR015 a-aaaa inputImage'],
    ],
    [
      'a required port without a wire, on the way to nothing',
      projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'a-aaaa': 'filter/sepia' } }),
      ['warning SCR015 a-aaaa inputImage'],
    ],
    [
      'two wires into a port for one',
      projectOf({
        nodes: { ...VIDEO_TO_SCREEN.nodes, 'video-bbbb': 'source/camera-video' },
        wires: ['video-aaaa.layer -> screen-aaaa.layer', 'video-bbbb.layer -> screen-aaaa.layer'],
      }),
      ['error SCR016 screen-aaaa layer'],
    ],
    [
      'the same wire twice into a port for several',
      projectOf({
        nodes: { ...VIDEO_TO_SCREEN.nodes, 'box-aaaa': 'objects/primitive', 'group-aaaa': 'objects/group' },
        wires: [...(VIDEO_TO_SCREEN.wires ?? []), 'box-aaaa.objects -> group-aaaa.objects', 'box-aaaa.objects -> group-aaaa.objects'],
      }),
      ['error SCR016 group-aaaa objects'],
    ],
    ['an unknown param', projectOf(withParams('value/number', { valve: { value: 1 } })), ['error SCR018 node-aaaa valve']],
    ['a value of another type', projectOf(withParams('value/number', { value: { value: 'much' } })), ['error SCR018 node-aaaa value']],
    ['NaN', projectOf(withParams('value/number', { value: { value: Number.NaN } })), ['error SCR018 node-aaaa value']],
    ['a vector that is too short', projectOf(withParams('value/color', { color: { value: [1, 1, 1] } })), ['error SCR018 node-aaaa color']],
    [
      'a curve of one point',
      projectOf(withParams('filter/curves', { tone: { value: [0.5, 0.5] } })),
      ['warning SCR015 node-aaaa inputImage', 'error SCR018 node-aaaa tone'],
    ],
    [
      'a curve with points out of order',
      projectOf(withParams('filter/curves', { tone: { value: [0, 0, 0.7, 1, 0.2, 1] } })),
      ['warning SCR015 node-aaaa inputImage', 'error SCR018 node-aaaa tone'],
    ],
    [
      'a curve with a point that is nowhere',
      projectOf(withParams('filter/curves', { tone: { value: [0, Number.NaN, 1, 1] } })),
      ['warning SCR015 node-aaaa inputImage', 'error SCR018 node-aaaa tone'],
    ],
    [
      'an expression for a curve',
      projectOf(withParams('filter/curves', { tone: { expression: 'time' } })),
      ['warning SCR015 node-aaaa inputImage', 'error SCR019 node-aaaa tone'],
    ],
    ['a choice that is none', projectOf(withParams('objects/primitive', { shape: { value: 'teapot' } })), ['error SCR018 node-aaaa shape']],
    [
      'a value out of range',
      projectOf(withParams('light/directional', { intensity: { value: -1 } })),
      ['warning SCR018 node-aaaa intensity'],
    ],
    [
      'an expression for what is fixed',
      projectOf(withParams('objects/primitive', { shape: { expression: 'x' } })),
      ['error SCR019 node-aaaa shape'],
    ],
    [
      'keyframes out of order',
      projectOf(
        withParams('value/number', {
          value: {
            track: {
              repeat: 'once',
              keys: [
                { timeS: 1, value: 0, easing: 'linear' },
                { timeS: 0, value: 0, easing: 'linear' },
              ],
            },
          },
        }),
      ),
      ['error SCR019 node-aaaa value'],
    ],
    [
      'handles of an easing that go back in time',
      projectOf(
        withParams('value/number', {
          value: { track: { repeat: 'once', keys: [{ timeS: 1, value: 0, easing: [-0.2, 0, 0.5, 1] }] } },
        }),
      ),
      ['error SCR019 node-aaaa value'],
    ],
    [
      'an asset that is not there',
      projectOf(withParams('source/model', { model: { value: 'fox-aaaa' } })),
      ['error SCR030 node-aaaa model'],
    ],
    [
      'an asset of another kind',
      projectOf(withParams('source/model', { model: { value: 'fox-aaaa' } }), {
        assets: { 'fox-aaaa': { path: 'assets/fox.png', kind: 'image' } },
      }),
      ['error SCR033 node-aaaa model'],
    ],
    [
      'a wire and an expression for the same param',
      projectOf({
        nodes: {
          ...VIDEO_TO_SCREEN.nodes,
          'n-aaaa': 'value/number',
          'm-aaaa': { type: 'value/math', version: 1, params: { a: { expression: '1' } } },
        },
        wires: [...(VIDEO_TO_SCREEN.wires ?? []), 'n-aaaa.value -> m-aaaa.a'],
      }),
      ['error SCR019 m-aaaa a'],
    ],
    [
      'an unknown subgraph',
      projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'g-aaaa': 'graph/look' } }),
      ['error SCR020 g-aaaa'],
    ],
    [
      'the main graph in itself',
      projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'g-aaaa': 'graph/main' } }),
      ['error SCR020', 'error SCR020 g-aaaa'],
    ],
    [
      'subgraphs within each other',
      projectOf(VIDEO_TO_SCREEN, { subgraphs: { one: { nodes: { 'a-aaaa': 'graph/two' } }, two: { nodes: { 'b-aaaa': 'graph/one' } } } }),
      ['error SCR020'],
    ],
    [
      'a screen in a subgraph',
      projectOf(VIDEO_TO_SCREEN, { subgraphs: { look: { nodes: { 's-aaaa': 'output/screen' } } } }),
      ['error SCR017 s-aaaa', 'warning SCR015 s-aaaa layer'],
    ],
    [
      'an exposed port that does not exist',
      projectOf(VIDEO_TO_SCREEN, {
        subgraphs: {
          look: {
            nodes: { 's-aaaa': 'filter/sepia' },
            exposed: {
              inputs: [
                { name: 'a', node: 's-aaaa', port: 'inputImage' },
                { name: 'b', node: 's-aaaa', port: 'x' },
              ],
              outputs: [],
            },
          },
        },
      }),
      ['error SCR012 s-aaaa x'],
    ],
  ])('tells of %s', (_, project, expected) => {
    expect(codes(project)).toEqual(expected);
  });

  test('every message says which node, and what to do or how it is', () => {
    const [diagnostic] = validate(
      projectOf({ nodes: { 'a-aaaa': 'filter/sepia', 'screen-aaaa': 'output/screen' }, wires: ['a-aaaa.layer -> screen-aaaa.layer'] }),
    );
    expect(diagnostic).toMatchObject({
      message: 'Input “inputImage” of a-aaaa is not connected.',
      fix: 'Connect it, or mute or delete the node.',
    });
  });

  test('a mistake in a subgraph names the subgraph', () => {
    const [diagnostic] = validate(projectOf(VIDEO_TO_SCREEN, { subgraphs: { look: { nodes: { 'x-aaaa': 'filter/nothing' } } } }));
    expect(diagnostic?.message).toMatch(/[^.] \(in the subgraph “look”\)\.$/);
  });

  test('what is unfinished in a subgraph is an error only where the screen depends on that', () => {
    const look: Sketch = {
      nodes: { 'sepia-aaaa': 'filter/sepia' },
      exposed: { inputs: [], outputs: [{ name: 'layer', node: 'sepia-aaaa', port: 'layer' }] },
    };
    const outer: Sketch = {
      nodes: { 'look-aaaa': 'graph/look' },
      exposed: { inputs: [], outputs: [{ name: 'layer', node: 'look-aaaa', port: 'layer' }] },
    };
    const aside = { ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'outer-aaaa': 'graph/outer' } };
    const unfinished = 'SCR015 sepia-aaaa inputImage';
    expect(codes(projectOf(aside, { subgraphs: { look, outer } }))).toEqual([`warning ${unfinished}`]);
    expect(codes(projectOf(VIDEO_TO_SCREEN, { subgraphs: { look } }))).toEqual([`warning ${unfinished}`]);
    const shown: Sketch = {
      nodes: { 'outer-aaaa': 'graph/outer', 'screen-aaaa': 'output/screen' },
      wires: ['outer-aaaa.layer -> screen-aaaa.layer'],
    };
    expect(codes(projectOf(shown, { subgraphs: { look, outer } }))).toEqual([`error ${unfinished}`]);
  });

  test('a required input that a subgraph shows is required of the node that stands for it', () => {
    const look: Sketch = {
      nodes: { 'sepia-aaaa': 'filter/sepia' },
      exposed: {
        inputs: [{ name: 'picture', node: 'sepia-aaaa', port: 'inputImage' }],
        outputs: [{ name: 'layer', node: 'sepia-aaaa', port: 'layer' }],
      },
    };
    const main: Sketch = {
      nodes: { 'look-aaaa': 'graph/look', 'screen-aaaa': 'output/screen' },
      wires: ['look-aaaa.layer -> screen-aaaa.layer'],
    };
    expect(codes(projectOf(main, { subgraphs: { look } }))).toEqual(['error SCR015 look-aaaa picture']);
  });

  test('a muted node needs no wires', () => {
    const sepia = { type: 'filter/sepia', version: 1, params: {}, muted: true };
    expect(codes(projectOf({ nodes: { ...VIDEO_TO_SCREEN.nodes, 'a-aaaa': sepia }, wires: VIDEO_TO_SCREEN.wires ?? [] }))).toEqual([]);
  });

  test('a node whose shader file is broken is told so', () => {
    const studio = new TestStudio({ library: TEST_LIBRARY, readShader }).source('edge.fs', '/* no header */ void main() {}');
    const project = {
      ...studio.project,
      graphs: projectOf({ ...VIDEO_TO_SCREEN, nodes: { ...VIDEO_TO_SCREEN.nodes, 'x-aaaa': 'filter/edge' } }).graphs,
    };
    expect(validateProject(project, studio.library)[0]?.message).toContain('shaders/edge.fs');
    expect(studio.library.diagnostics).toMatchObject([{ code: 'SCR040', file: 'shaders/edge.fs' }]);
  });

  test('ten thousand nodes in a chain take as much work each as a thousand', () => {
    const questions = (count: number): number => {
      const nodes = Object.fromEntries(Array.from({ length: count }, (_, i) => [`s-${i}`, 'filter/sepia']));
      const wires = Array.from({ length: count - 1 }, (_, i) => `s-${i}.layer -> s-${i + 1}.inputImage`);
      const project = projectOf({
        nodes: { ...nodes, 'screen-a': 'output/screen', 'video-a': 'source/camera-video' },
        wires: [...wires, 'video-a.layer -> s-0.inputImage', `s-${count - 1}.layer -> screen-a.layer`],
      });
      let asked = 0;
      const counting: NodeLibrary = {
        ...TEST_LIBRARY,
        definition: (type) => {
          asked++;
          return TEST_LIBRARY.definition(type);
        },
      };
      expect(validateProject(project, counting)).toEqual([]);
      return asked;
    };
    expect(questions(10_000) / 10_000).toBeLessThanOrEqual((questions(1000) / 1000) * 1.05);
  });
});
