import { describe, expect, test } from '@jest/globals';
import { TEST_LIBRARY as library, readShader } from '../../tests/support/test-library.ts';
import { TestStudio } from '../../tests/support/test-studio.ts';
import { changeType } from './commands/change-type.ts';
import { createSubgraph } from './commands/create-subgraph.ts';
import { pruneRoutesAfter, putReroute, setRoutes } from './commands/route-commands.ts';
import { ungroupSubgraph } from './commands/ungroup-subgraph.ts';
import { loadProject } from './load.ts';
import { EMPTY_LAYOUT } from './new-project.ts';
import { pruneRoutes, stretchesOf } from './routes.ts';
import { parseWire } from './wires.ts';

const TO_SEPIA = 'video-aaaa.layer -> sepia-aaaa.inputImage';
const TO_OVER = 'video-aaaa.layer -> over-aaaa.bottom';
const ONWARD = 'sepia-aaaa.layer -> over-aaaa.top';

function wiresOf(...texts: readonly string[]) {
  return { wires: texts.flatMap((text) => parseWire(text) ?? []) };
}

const AT = { x: 8, y: 8 };

/** The camera's picture goes to a sepia and to an operator, both by way of `trunk`, and on to the sepia by `twig`. */
function studio(): TestStudio {
  return new TestStudio({ library, readShader })
    .add('video-aaaa', 'source/camera-video')
    .add('sepia-aaaa', 'filter/sepia')
    .add('over-aaaa', 'operator/over')
    .wire(TO_SEPIA, TO_OVER, ONWARD)
    .run((p) => putReroute(p, { graph: 'main', id: 'trunk', reroute: { x: 100.4, y: -0.2 } }))
    .run((p) => putReroute(p, { graph: 'main', id: 'twig', reroute: { x: 200, y: 40 } }))
    .run((p) => setRoutes(p, { graph: 'main', routes: { [TO_SEPIA]: ['trunk', 'twig'], [TO_OVER]: ['trunk'] } }));
}

describe('what is drawn', () => {
  test('wires share their way up to where they part', () => {
    const { graphs, layout } = studio().project;
    const stretches = [...stretchesOf(graphs.main ?? { wires: [] }, layout.main ?? EMPTY_LAYOUT)];
    expect(stretches.map(([id, { wires, before, to }]) => [id, wires.length, before, to])).toEqual([
      ['video-aaaa.layer via nothing to trunk', 2, [], 'trunk'],
      [TO_OVER, 1, ['trunk'], null],
      [ONWARD, 1, [], null],
      ['video-aaaa.layer via trunk to twig', 1, ['trunk'], 'twig'],
      [TO_SEPIA, 1, ['trunk', 'twig'], null],
    ]);
  });

  test('routes of wires that are gone, through points that are gone, in rings or from two outputs are not', () => {
    const pruned = pruneRoutes(wiresOf(TO_SEPIA, TO_OVER, ONWARD), {
      ...EMPTY_LAYOUT,
      reroutes: { a: AT, b: AT, unused: AT },
      routes: {
        [TO_SEPIA]: ['a', 'gone', 'b', 'a'],
        [TO_OVER]: ['b', 'a'],
        [ONWARD]: ['a'],
        'other-aaaa.layer -> sepia-aaaa.inputImage': ['unused'],
      },
    });
    expect(pruned.routes).toEqual({ [TO_SEPIA]: ['a', 'b'], [TO_OVER]: ['a'] });
    expect(Object.keys(pruned.reroutes)).toEqual(['a', 'b']);
    expect(pruneRoutes(wiresOf(TO_SEPIA, TO_OVER, ONWARD), pruned)).toBe(pruned);
  });
});

describe('in the files', () => {
  test('they are the layout alone, in whole units, and come back the same', () => {
    const made = studio();
    const { project, layout } = made.save();
    expect(project).not.toContain('trunk');
    expect(layout).toContain('"trunk": { "x": 100, "y": 0 }');
    expect(layout).toContain(`"${TO_SEPIA}": ["trunk", "twig"]`);
    expect(loadProject({ project, layout, sources: {} }).output).toEqual(made.project);
  });

  test('what no wire can be led through is left out; what is no route at all costs the layout, never the graph', () => {
    const { project, layout } = studio().save();
    const load = (from: string, to: string) => loadProject({ project, layout: layout?.replace(from, to) ?? null, sources: {} });
    const loose = load('"trunk": { "x": 100, "y": 0 },', '');
    expect(loose.diagnostics).toEqual([]);
    expect(loose.output?.layout.main?.routes).toEqual({ [TO_SEPIA]: ['twig'] });
    const broken = load('["trunk", "twig"]', '"trunk"');
    expect(broken.diagnostics.map(({ severity, code }) => `${severity} ${code}`)).toEqual(['warning SCR002']);
    expect(broken.output?.graphs).toEqual(studio().project.graphs);
  });
});

describe('wires that become others keep their ways', () => {
  test('as another type of node', () => {
    const made = studio().run((p) =>
      pruneRoutesAfter(p, changeType(p, { library, graph: 'main', node: 'sepia-aaaa', type: 'operator/over' })),
    );
    expect(made.project.layout.main?.routes).toEqual({
      'video-aaaa.layer -> sepia-aaaa.top': ['trunk', 'twig'],
      [TO_OVER]: ['trunk'],
    });
  });

  test('into a subgraph and out again', () => {
    const packed = studio().run((p) =>
      pruneRoutesAfter(
        p,
        createSubgraph(p, { library, graph: 'main', nodes: ['video-aaaa', 'sepia-aaaa'], name: 'look', id: 'look-aaaa', x: 0, y: 0 }),
      ),
    );
    expect(packed.project.layout.look?.routes).toEqual({ [TO_SEPIA]: ['trunk', 'twig'] });
    expect(packed.project.layout.main?.routes).toEqual({ 'look-aaaa.layer -> over-aaaa.bottom': ['trunk'] });
    const unpacked = packed.run((p) =>
      pruneRoutesAfter(p, ungroupSubgraph(p, { library, graph: 'main', node: 'look-aaaa', random: () => 0.5 })),
    );
    const { routes = {}, reroutes = {} } = unpacked.project.layout.main ?? {};
    expect(
      Object.values(routes)
        .map(({ length }) => length)
        .sort(),
    ).toEqual([1, 2]);
    expect(Object.keys(reroutes)).toHaveLength(3);
  });
});
