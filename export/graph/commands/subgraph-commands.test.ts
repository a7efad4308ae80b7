import { describe, expect, test } from '@jest/globals';
import { program } from '../../../tests/compile/compiled.ts';
import { arScene, emptyStudio } from '../../../tests/compile/graphs.ts';
import type { TestStudio } from '../../../tests/support/test-studio.ts';
import type { Project } from '../project.ts';
import { printWire } from '../wires.ts';
import { createSubgraph } from './create-subgraph.ts';
import { duplicateSubgraph, ungroupSubgraph } from './ungroup-subgraph.ts';

/** Counts up, so that ids are new and the same every time. */
function counting(): () => number {
  let next = 0;
  return () => next++ / 1000;
}

function packing(studio: TestStudio, nodes: readonly string[], name = 'look', graph = 'main') {
  return (project: Project) => createSubgraph(project, { library: studio.library, graph, nodes, name, id: `${name}-a`, x: 10, y: 20 });
}

function wiresOf(project: Project, graph: string): readonly string[] {
  return (project.graphs[graph]?.wires ?? []).map(printWire).sort();
}

/** What is drawn, of what: operations with their shaders and values, whatever their nodes are called. */
function picture(studio: TestStudio): unknown {
  const { operations, slots, resources } = program(studio.reopen());
  const named = JSON.stringify({
    kinds: operations.map(({ kind }) => kind).sort(),
    resources: resources.map(({ kind }) => kind).sort(),
    numbers: [...slots.numbers].sort(),
  });
  return JSON.parse(named.replaceAll(/\b(?:[a-z]+-[a-z0-9]+\/)*[a-z-]+-[a-z0-9]+\b/g, 'node'));
}

/** Video → sepia → blur → edges → screen; a number sets the blur. */
function chain(): TestStudio {
  return emptyStudio()
    .add('video-a', 'source/camera-video')
    .add('sepia-a', 'filter/sepia', { amount: 0.25 })
    .add('blur-a', 'filter/gaussian-blur')
    .add('sobel-a', 'filter/sobel-edges')
    .add('number-a', 'value/number', { value: 3 })
    .add('screen-a', 'output/screen')
    .wire(
      'video-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> blur-a.inputImage',
      'blur-a.layer -> sobel-a.inputImage',
      'sobel-a.layer -> screen-a.layer',
      'number-a.value -> blur-a.radius',
    );
}

describe('nodes put into a subgraph', () => {
  test('are wired as they were, through ports of the node in their place; undo is one step', () => {
    const studio = chain();
    const before = studio.project;
    studio.run(packing(studio, ['sepia-a', 'blur-a']));
    expect(wiresOf(studio.project, 'main')).toEqual([
      'look-a.layer -> sobel-a.inputImage',
      'number-a.value -> look-a.radius',
      'sobel-a.layer -> screen-a.layer',
      'video-a.layer -> look-a.inputImage',
    ]);
    expect(wiresOf(studio.project, 'look')).toEqual(['sepia-a.layer -> blur-a.inputImage']);
    expect(studio.project.layout.main?.nodes['look-a']).toEqual({ x: 10, y: 20 });
    expect(studio.diagnostics()).toEqual([]);
    expect(studio.undo().project).toEqual(before);
  });

  test('give the same picture', () => {
    const flat = picture(chain());
    const packed = chain();
    packed.run(packing(packed, ['sepia-a', 'blur-a']));
    expect(picture(packed)).toEqual(flat);
    const scene = arScene();
    scene.run(packing(scene, ['place-a', 'scene-a', 'hide-a', 'shadow-a', 'floor-a', 'box-a']));
    expect(picture(scene)).toEqual(picture(arScene()));
  });

  test('may be put into another one; exposed ports stay exposed', () => {
    const studio = chain();
    studio.run(packing(studio, ['sepia-a', 'blur-a', 'sobel-a'], 'outer'));
    studio.run(packing(studio, ['blur-a', 'sobel-a'], 'inner', 'outer'));
    expect(wiresOf(studio.project, 'outer')).toEqual(['sepia-a.layer -> inner-a.inputImage']);
    expect(studio.project.graphs.outer?.exposed.outputs).toEqual([{ name: 'layer', node: 'inner-a', port: 'layer' }]);
    expect(wiresOf(studio.project, 'main')).toContain('number-a.value -> outer-a.radius');
    expect(studio.diagnostics()).toEqual([]);
    expect(picture(studio)).toEqual(picture(chain()));
  });

  test('cannot have a node between them that is not in it, nor the screen', () => {
    const studio = chain();
    const { project } = studio;
    const said = (nodes: readonly string[]) => studio.attempt(packing(studio, nodes))[0]?.message;
    expect(said(['sepia-a', 'sobel-a'])).toBe('blur-a lies between the nodes of the subgraph. Include it, or connect around it.');
    expect(said(['sobel-a', 'screen-a'])).toMatch(/^screen-a must stay/);
    expect(said(['gone-a'])).toMatch(/^No node is selected/);
    expect(studio.project).toBe(project);
  });
});

describe('an unpacked subgraph', () => {
  const unpacking = (studio: TestStudio, node: string) => (project: Project) =>
    ungroupSubgraph(project, { library: studio.library, graph: 'main', node, random: counting() });

  test('leaves the picture as it is', () => {
    const studio = chain();
    studio.run(packing(studio, ['sepia-a', 'blur-a']));
    studio.run(unpacking(studio, 'look-a'));
    expect(picture(studio)).toEqual(picture(chain()));
  });

  test('gives back what was put in, and stays for its other users', () => {
    const studio = chain();
    studio
      .run(packing(studio, ['sepia-a', 'blur-a']))
      .in('look')
      .expose('inputs', 'amount', 'sepia-a.amount')
      .in('main');
    studio.set('look-a.amount', 0.75).add('look-b', 'graph/look');
    const packed = studio.project;
    studio.run(unpacking(studio, 'look-a'));
    const nodes = Object.entries(studio.project.graphs.main?.nodes ?? {});
    const idOf = (type: string) => nodes.find(([, node]) => node.type === type)?.[0] ?? '';
    const [sepia, blur] = [idOf('filter/sepia'), idOf('filter/gaussian-blur')];
    expect(wiresOf(studio.project, 'main')).toEqual(
      [
        `${blur}.layer -> sobel-a.inputImage`,
        `${sepia}.layer -> ${blur}.inputImage`,
        `number-a.value -> ${blur}.radius`,
        'sobel-a.layer -> screen-a.layer',
        `video-a.layer -> ${sepia}.inputImage`,
      ].sort(),
    );
    expect(studio.project.graphs.main?.nodes[sepia]?.params).toEqual({ amount: { value: 0.75 } });
    expect(studio.project.graphs.look).toBe(packed.graphs.look);
    // The other user has no wires, and says so; nothing else is wrong.
    expect(studio.diagnostics().map(({ nodeId }) => nodeId)).toEqual(['look-b']);
    expect(studio.undo().project).toEqual(packed);
  });

  test('is told from a node of the library', () => {
    const studio = chain();
    expect(studio.attempt(unpacking(studio, 'sepia-a'))[0]?.message).toBe('sepia-a is not a subgraph.');
  });
});

test('a duplicated subgraph has the same insides and ids of its own', () => {
  const studio = chain();
  studio.run(packing(studio, ['sepia-a', 'blur-a']));
  studio.run((project) => duplicateSubgraph(project, { from: 'look', to: 'look-2', random: counting() }));
  const { graphs, layout } = studio.project;
  const ids = Object.keys(graphs['look-2']?.nodes ?? {});
  expect(ids).toHaveLength(2);
  expect(ids.some((id) => Object.hasOwn(graphs.look?.nodes ?? {}, id))).toBe(false);
  expect(Object.values(graphs['look-2']?.nodes ?? {})).toEqual(Object.values(graphs.look?.nodes ?? {}));
  expect(Object.keys(layout['look-2']?.nodes ?? {}).sort()).toEqual([...ids].sort());
  studio.add('look-b', 'graph/look-2');
  expect(studio.attempt((project) => duplicateSubgraph(project, { from: 'look', to: 'look-2', random: counting() }))[0]?.message).toMatch(
    /A graph named “look-2” already exists/,
  );
  studio.reopen();
});
