import { describe, expect, test } from '@jest/globals';
import { compile } from '../../export/compiler/compile.ts';
import type { Graph, Project } from '../../export/graph/project.ts';
import { TEST_LIBRARY as library } from '../support/test-library.ts';
import type { TestStudio } from '../support/test-studio.ts';
import { ids, passes, program } from './compiled.ts';
import { emptyStudio, subgraphs } from './graphs.ts';

/** As a file may say, though no command would. */
function withNode(project: Project, graph: string, id: string, type: string): Project {
  const found = project.graphs[graph] as Graph;
  const nodes = { ...found.nodes, [id]: { type, version: 1, params: {} } };
  return { ...project, graphs: { ...project.graphs, [graph]: { ...found, nodes } } };
}

function refusal(project: Project): readonly string[] {
  const { output, diagnostics } = compile({ project, library });
  expect(output).toBeNull();
  return diagnostics.map(({ code, message }) => `${code} ${message}`);
}

describe('a subgraph that contains itself is refused, with the way round', () => {
  test.each([
    ['directly', 'look', 'graph/look', 'look → look'],
    ['through another', 'look', 'graph/twice', 'look → twice → look'],
  ])('%s', (_, graph, type, loop) => {
    expect(refusal(withNode(subgraphs().project, graph, 'again-a', type))).toEqual([`SCR020 A subgraph contains itself: ${loop}.`]);
  });

  test('by way of the main graph', () => {
    expect(refusal(withNode(subgraphs().project, 'look', 'again-a', 'graph/main'))[0]).toMatch(/^SCR020 /);
  });

  test('even where nothing on screen uses it', () => {
    const studio = emptyStudio().in('lonely').in('main').add('video-a', 'source/camera-video').add('screen-a', 'output/screen');
    studio.wire('video-a.layer -> screen-a.layer');
    expect(refusal(withNode(studio.project, 'lonely', 'again-a', 'graph/lonely'))[0]).toContain('lonely → lonely');
  });
});

test('a subgraph that does not exist is told at the node that uses it', () => {
  expect(refusal(withNode(subgraphs().project, 'main', 'gone-a', 'graph/gone'))).toEqual([
    'SCR020 gone-a uses the subgraph “gone”, which does not exist.',
  ]);
});

describe('the same picture', () => {
  /** A chain of a sepia and a sobel, as nodes of the main graph or as a subgraph. */
  const inside = (studio: TestStudio) =>
    studio
      .add('sepia-a', 'filter/sepia', { amount: 0.25 })
      .add('sobel-a', 'filter/sobel-edges')
      .wire('sepia-a.layer -> sobel-a.inputImage');
  const around = (studio: TestStudio) => studio.in('main').add('video-a', 'source/camera-video').add('screen-a', 'output/screen');
  const flat = () => around(inside(emptyStudio())).wire('video-a.layer -> sepia-a.inputImage', 'sobel-a.layer -> screen-a.layer');
  const nested = () =>
    around(inside(emptyStudio().in('look')).expose('inputs', 'picture', 'sepia-a.inputImage').expose('outputs', 'layer', 'sobel-a.layer'))
      .add('look-a', 'graph/look')
      .wire('video-a.layer -> look-a.picture', 'look-a.layer -> screen-a.layer');

  test('comes of nodes put into a subgraph: the program differs in their ids alone', () => {
    const renamed = JSON.parse(JSON.stringify(program(nested())).replaceAll('look-a/', ''));
    const plain = program(flat());
    const { params: _, ...slots } = plain.slots;
    expect({ ...renamed, slots: { ...renamed.slots, params: null } }).toEqual({ ...plain, slots: { ...slots, params: null } });
  });

  test('and ids say where a node is', () => {
    expect(ids(program(nested()), 'pass')).toEqual(['look-a/sepia-a.pass0', 'look-a/sobel-a.pass0']);
    expect(passes(program(subgraphs())).map(({ node }) => node)).toEqual([
      'twice-a/first-a/sepia-a',
      'twice-a/first-a/sobel-a',
      'twice-a/second-a/sepia-a',
      'twice-a/second-a/sobel-a',
    ]);
  });
});
