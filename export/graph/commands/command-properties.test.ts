import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import fc from 'fast-check';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import type { Easing } from '../../../nodes/kit/ease.ts';
import { TEST_LIBRARY as base, readShader, TEST_SHADERS } from '../../../tests/support/test-library.ts';
import { makeLayoutId, makeNodeId } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { projectLibrary } from '../library/project-library.ts';
import { loadProject } from '../load.ts';
import { newProject } from '../new-project.ts';
import type { PortAddress, Project } from '../project.ts';
import { getOwn } from '../record.ts';
import { routeOf } from '../routes.ts';
import { saveProject } from '../save.ts';
import { validateProject } from '../validate/validate.ts';
import { printWire, sortWires } from '../wires.ts';
import { putAsset, removeAsset } from './asset-commands.ts';
import { applyPatches, type Change, sequence } from './change.ts';
import { changeType } from './change-type.ts';
import { createSubgraph } from './create-subgraph.ts';
import { moveNodes, putFrame, putNote, removeFromLayout, setCollapsed } from './layout-commands.ts';
import { addNode, removeNodes, setMuted, setUnfused } from './node-commands.ts';
import { bindParam, setParam } from './param-commands.ts';
import { replaceProject, setFraming, setKeywords, setPage, setPoster, setTitle } from './project-info.ts';
import { pruneRoutesAfter, putReroute, setRoutes } from './route-commands.ts';
import { forkShader, removeSource, setSource } from './shader-commands.ts';
import { addGraph, exposePort, hidePort, removeGraph, renameExposed, renameGraph } from './subgraph-commands.ts';
import { duplicateSubgraph, ungroupSubgraph } from './ungroup-subgraph.ts';
import { connect, disconnect, reorderWires } from './wire-commands.ts';

/** Random numbers that pick from whatever the project has at the time, so that most commands do something. */
type Dice = readonly number[];

interface Picker {
  next(): number;
  of<T>(items: readonly T[]): T | undefined;
}

function pickerOf(dice: Dice): Picker {
  let at = 0;
  const next = () => dice[at++ % dice.length] ?? 0;
  return { next, of: (items) => items[Math.floor(next() * items.length)] };
}

const VALUES: readonly ParamValue[] = [
  0,
  -0,
  0.5,
  1,
  -3,
  true,
  false,
  '',
  'sphere',
  'fox-aaaa',
  [1, 0, 0, 1],
  [0, -0, 2],
  [0, 1, 0.5, 0.25, 1, -0],
  [0.5, 0, 0.5, 1],
  Number.NaN,
  [Number.NaN, 0, 0],
];
const TEXTS = [...Object.values(TEST_SHADERS), 'no header', '/*{"INPUTS":[]}*/void main(){}'];

const library = (project: Project) => projectLibrary(base, project.sources, readShader);

function anyGraph(project: Project, pick: Picker): string {
  return pick.of(Object.keys(project.graphs)) ?? 'main';
}

function anyNode(project: Project, graph: string, pick: Picker): string {
  return pick.of(Object.keys(getOwn(project.graphs, graph)?.nodes ?? {})) ?? 'nothing-aaaa';
}

function anyPort(project: Project, graph: string, side: 'inputs' | 'outputs', pick: Picker): PortAddress {
  const node = anyNode(project, graph, pick);
  const nodeInterface = createInterfaceLookup(project, library(project))(project.graphs[graph]?.nodes[node]?.type ?? '');
  const names = nodeInterface ? [...Object.keys(nodeInterface[side]), ...(side === 'inputs' ? Object.keys(nodeInterface.params) : [])] : [];
  return { node, port: pick.of(names) ?? 'nothing' };
}

type Command = (project: Project, pick: Picker) => Change;

const LAYOUT_COMMANDS: Readonly<Record<string, Command>> = {
  move: (p, pick) => {
    const graph = anyGraph(p, pick);
    return moveNodes(p, { graph, positions: { [anyNode(p, graph, pick)]: { x: 1000 * pick.next() - 500, y: -0.2 } } });
  },
  collapse: (p, pick) => {
    const graph = anyGraph(p, pick);
    return setCollapsed(p, { graph, nodes: [anyNode(p, graph, pick)], collapsed: pick.next() > 0.5 });
  },
  frame: (p, pick) => {
    const graph = anyGraph(p, pick);
    const id = makeLayoutId(p, graph, 'frame', pick.next);
    return putFrame(p, { graph, id, frame: { x: -0.1, y: 1e6 * pick.next(), width: 10, height: 10, title: 'x' } });
  },
  note: (p, pick) =>
    putNote(p, {
      graph: 'main',
      id: makeLayoutId(p, 'main', 'note', pick.next),
      note: { x: 0, y: 0, width: 1, height: 1, text: '"\u2028' },
    }),
  lead: (p, pick) => {
    const graph = anyGraph(p, pick);
    const layout = getOwn(p.layout, graph);
    const wire = pick.of(getOwn(p.graphs, graph)?.wires ?? []);
    const id = pick.of([...Object.keys(layout?.reroutes ?? {}), makeLayoutId(p, graph, 'reroute', pick.next)]) ?? '';
    const route = [...(wire && layout ? routeOf(layout, wire) : []), id];
    const led = sequence(
      p,
      (before) => putReroute(before, { graph, id, reroute: { x: 99.5, y: -0.1 } }),
      (before) => setRoutes(before, { graph, routes: wire ? { [printWire(wire)]: route } : {} }),
      (before) => moveNodes(before, { graph, positions: {}, reroutes: { [id]: { x: 1e3 * pick.next(), y: -0.4 } } }),
    );
    return pruneRoutesAfter(p, led);
  },
  straighten: (p, pick) => {
    const graph = anyGraph(p, pick);
    const reroute = pick.of(Object.keys(getOwn(p.layout, graph)?.reroutes ?? {}));
    return removeFromLayout(p, { graph, reroutes: reroute === undefined ? [] : [reroute] });
  },
  unframe: (p, pick) => {
    const graph = anyGraph(p, pick);
    const frame = pick.of(Object.keys(getOwn(p.layout, graph)?.frames ?? {}));
    return removeFromLayout(p, { graph, frames: frame === undefined ? [] : [frame] });
  },
};

const LOGIC_COMMANDS: Readonly<Record<string, Command>> = {
  add: (p, pick) => {
    const graph = anyGraph(p, pick);
    const type = pick.of([...library(p).types(), ...Object.keys(p.graphs).map((name) => `graph/${name}`)]) ?? '';
    return addNode(p, { library: library(p), graph, id: makeNodeId(p, type, pick.next), type, x: pick.next(), y: 0 });
  },
  remove: (p, pick) => {
    const graph = anyGraph(p, pick);
    return removeNodes(p, { library: library(p), graph, nodes: [anyNode(p, graph, pick)] });
  },
  mute: (p, pick) => {
    const graph = anyGraph(p, pick);
    return setMuted(p, { graph, nodes: [anyNode(p, graph, pick)], muted: pick.next() > 0.3 });
  },
  unfuse: (p, pick) => {
    const graph = anyGraph(p, pick);
    return setUnfused(p, { graph, nodes: [anyNode(p, graph, pick)], unfused: pick.next() > 0.3 });
  },
  connect: (p, pick) => {
    const graph = anyGraph(p, pick);
    return connect(p, { library: library(p), graph, from: anyPort(p, graph, 'outputs', pick), to: anyPort(p, graph, 'inputs', pick) });
  },
  disconnect: (p, pick) => {
    const graph = anyGraph(p, pick);
    const wire = pick.of(p.graphs[graph]?.wires ?? []);
    return disconnect(p, { graph, wires: wire ? [wire] : [] });
  },
  reorder: (p, pick) => {
    const graph = anyGraph(p, pick);
    const wire = pick.of(p.graphs[graph]?.wires ?? []);
    return wire ? reorderWires(p, { graph, to: wire.to, from: [wire.from] }) : disconnect(p, { graph, wires: [] });
  },
  set: (p, pick) => {
    const graph = anyGraph(p, pick);
    const { node, port: param } = anyPort(p, graph, 'inputs', pick);
    return setParam(p, { library: library(p), graph, node, param, value: pick.of(VALUES) ?? 0 });
  },
  bind: (p, pick) => {
    const graph = anyGraph(p, pick);
    const { node, port: param } = anyPort(p, graph, 'inputs', pick);
    const value = pick.of(VALUES) ?? 0;
    const easing = pick.of<Easing>(['step', [0.3, -0.5, 0.1, 1.6]]) ?? 'linear';
    const track = { keys: [{ timeS: 0, value: 1, easing }], repeat: 'mirror' as const };
    const binding = pick.of([{ value }, { port: value }, { track }, { expression: 'time' }, { expression: '1 +' }]) ?? { value };
    return bindParam(p, { library: library(p), graph, node, param, binding });
  },
  type: (p, pick) => {
    const graph = anyGraph(p, pick);
    return changeType(p, { library: library(p), graph, node: anyNode(p, graph, pick), type: pick.of([...library(p).types()]) ?? '' });
  },
  pack: (p, pick) => {
    const graph = anyGraph(p, pick);
    const nodes = [anyNode(p, graph, pick), anyNode(p, graph, pick), anyNode(p, graph, pick)];
    const id = makeNodeId(p, 'graph/pack', pick.next);
    return createSubgraph(p, { library: library(p), graph, nodes, name: `g${Math.floor(8 * pick.next())}`, id, x: pick.next(), y: -0.2 });
  },
  unpack: (p, pick) => {
    const graph = anyGraph(p, pick);
    const subgraphs = Object.entries(getOwn(p.graphs, graph)?.nodes ?? {}).filter(([, { type }]) => type.startsWith('graph/'));
    return ungroupSubgraph(p, { library: library(p), graph, node: pick.of(subgraphs)?.[0] ?? 'nothing-aaaa', random: pick.next });
  },
  copy: (p, pick) => duplicateSubgraph(p, { from: anyGraph(p, pick), to: `g${Math.floor(8 * pick.next())}`, random: pick.next }),
  graph: (p, pick) => addGraph(p, { name: `g${Math.floor(4 * pick.next())}` }),
  rename: (p, pick) => renameGraph(p, { from: anyGraph(p, pick), to: `g${Math.floor(8 * pick.next())}` }),
  ungraph: (p, pick) => removeGraph(p, { name: anyGraph(p, pick) }),
  expose: (p, pick) => {
    const graph = anyGraph(p, pick);
    const side = pick.next() > 0.5 ? 'inputs' : 'outputs';
    return exposePort(p, { library: library(p), graph, side, name: `p${Math.floor(6 * pick.next())}`, ...anyPort(p, graph, side, pick) });
  },
  hide: (p, pick) => {
    const graph = anyGraph(p, pick);
    const side = pick.next() > 0.5 ? 'inputs' : 'outputs';
    return hidePort(p, { library: library(p), graph, side, name: pick.of(p.graphs[graph]?.exposed[side] ?? [])?.name ?? 'p' });
  },
  renamePort: (p, pick) => {
    const graph = anyGraph(p, pick);
    const side = pick.next() > 0.5 ? 'inputs' : 'outputs';
    const from = pick.of(p.graphs[graph]?.exposed[side] ?? [])?.name;
    return from === undefined
      ? setTitle(p, { title: p.title })
      : renameExposed(p, { graph, side, from, to: `p${Math.floor(6 * pick.next())}` });
  },
  source: (p, pick) =>
    setSource(p, { base, readShader, file: pick.of(['edge.fs', 'sepia.fs', 'edge.vs']) ?? '', text: pick.of(TEXTS) ?? '' }),
  unsource: (p, pick) => removeSource(p, { base, readShader, file: pick.of(Object.keys(p.sources)) ?? 'none.fs' }),
  fork: (p, pick) => {
    const graph = anyGraph(p, pick);
    return forkShader(p, { library: library(p), graph, node: anyNode(p, graph, pick) });
  },
  asset: (p, pick) => putAsset(p, { id: 'fox-aaaa', asset: { path: 'assets/fox', kind: pick.next() > 0.5 ? 'model' : 'image' } }),
  unasset: (p) => removeAsset(p, { library: library(p), id: 'fox-aaaa' }),
  title: (p, pick) => setTitle(p, { title: `T${pick.next()}` }),
  replace: (p, pick) => replaceProject(p, setTitle(p, { title: `T${pick.next()}` }).project),
  poster: (p, pick) => setPoster(p, { path: pick.of([null, 'assets/poster.jpg']) ?? null }),
  framing: (p, pick) => setFraming(p, { framing: pick.of([null, { center: [0, 0.1], height: 0.5 }]) ?? null }),
  keywords: (p, pick) => setKeywords(p, { keywords: pick.of([[], ['film', 'grain']]) ?? [] }),
  page: (p, pick) => setPage(p, { page: { language: pick.of(['en', 'de']) ?? '', description: pick.of(['', 'x']) ?? '' } }),
};

function steps(commands: Readonly<Record<string, Command>>, maxLength: number) {
  const dice = fc.array(
    fc.noBias(fc.nat(2 ** 20 - 1)).map((number) => number / 2 ** 20),
    { minLength: 8, maxLength: 8 },
  );
  return fc.array(fc.tuple(fc.constantFrom(...Object.keys(commands)), dice), { minLength: 5, maxLength, size: 'max' });
}

function play(commands: Readonly<Record<string, Command>>, name: string, project: Project, dice: Dice): Change {
  const command = commands[name];
  if (!command) throw new Error(`No command ${name}`);
  return pruneRoutesAfter(project, command(project, pickerOf(dice)));
}

/** No screen, one too many, no wire where one is needed, half an expression, no asset of the right kind: a person is at work. */
const UNFINISHED: ReadonlySet<string> = new Set(['SCR015', 'SCR017', 'SCR022', 'SCR033']);

const ALL = { ...LOGIC_COMMANDS, ...LAYOUT_COMMANDS };

const START_TYPES = [
  'layer/scene',
  'filter/sepia',
  'filter/curves',
  'operator/over',
  'value/number',
  'source/model',
  'objects/primitive',
  'objects/group',
];

/** Some nodes, and a port with two wires to put in another order. */
function start(): Project {
  const id = (type: string) => makeNodeId(newProject(''), type, () => 0.3);
  const added = START_TYPES.reduce(
    (project, type) => addNode(project, { library: base, graph: 'main', id: id(type), type, x: 0, y: 0 }).project,
    newProject('Start'),
  );
  return ['source/model', 'objects/primitive'].reduce((project, type) => {
    const from = { node: id(type), port: 'objects' };
    return connect(project, { library: base, graph: 'main', from, to: { node: id('objects/group'), port: 'objects' } }).project;
  }, added);
}

/** What commands are made of, and no commands themselves. */
const PARTS = ['carry-rename.ts', 'change.ts', 'prune-connections.ts'];
/** `convertLayers` follows a connection of scene layers, which these graphs do not have; encoding-lookup.test.ts plays it. */
const HELPERS = [
  ...['draftLayout', 'usesGraph', 'usersOfGraph', 'copyOfGraph', 'checkLayoutId', 'rounded'],
  ...['convertLayers', 'misfittingWires'],
];

test('every command there is takes part', async () => {
  const folder = import.meta.dirname;
  const files = (await readdir(folder)).filter((name) => !name.endsWith('.test.ts') && !PARTS.includes(name));
  const modules = await Promise.all(files.map((name) => import(join(folder, name)) as Promise<Record<string, unknown>>));
  const names = modules.flatMap((module) => Object.keys(module)).filter((name) => !HELPERS.includes(name));
  expect(names.length).toBeGreaterThan(20);
  const played = Object.values(ALL).map(String).join('\n');
  expect(names.filter((name) => !played.includes(`${name})(`) && !played.includes(`${name}(`))).toEqual([]);
});

describe('any sequence of commands', () => {
  test('undone in reverse gives the same bytes back, and done again the same again', () => {
    const done = new Map<string, number>();
    fc.assert(
      fc.property(steps(ALL, 40), (sequence) => {
        let project = start();
        const changes: Change[] = [];
        const saves = [saveProject(project)];
        for (const [name, dice] of sequence) {
          const change = play(ALL, name, project, dice);
          if (change.patches.length > 0) done.set(name, (done.get(name) ?? 0) + 1);
          project = change.project;
          changes.push(change);
          const saved = saveProject(project);
          // To move things about changes no byte of what the picture depends on, whatever was done before.
          if (name in LAYOUT_COMMANDS) expect({ ...saved, layout: null }).toEqual({ ...saves.at(-1), layout: null });
          saves.push(saved);
        }
        for (const [i, change] of [...changes.entries()].reverse()) {
          project = applyPatches(project, change.inverse);
          expect(saveProject(project)).toEqual(saves[i]);
        }
        for (const [i, change] of changes.entries()) {
          project = applyPatches(project, change.patches);
          expect(saveProject(project)).toEqual(saves[i + 1]);
        }
      }),
      { seed: 2, numRuns: 150 },
    );
    // A command that was always refused would prove nothing.
    expect([...done.keys()].sort()).toEqual(Object.keys(ALL).sort());
  });

  test('leaves a project that is saved and loaded as it is, with its wires in order', () => {
    fc.assert(
      fc.property(steps(ALL, 40), (sequence) => {
        const project = sequence.reduce((before, [name, dice]) => play(ALL, name, before, dice).project, start());
        expect(loadProject(saveProject(project))).toEqual({ output: project, diagnostics: [] });
        for (const { wires } of Object.values(project.graphs)) expect(wires).toEqual(sortWires(wires));
      }),
      { seed: 2, numRuns: 150 },
    );
  });

  test('leaves nothing wrong behind but what is unfinished', () => {
    fc.assert(
      fc.property(steps(ALL, 40), (sequence) => {
        const project = sequence.reduce((before, [name, dice]) => play(ALL, name, before, dice).project, start());
        // What hangs on a shader with a broken header waits until it is mended.
        if (library(project).diagnostics.length > 0) return;
        const wrong = validateProject(project, library(project)).filter(
          ({ severity, code }) => severity === 'error' && !UNFINISHED.has(code),
        );
        expect(wrong).toEqual([]);
      }),
      { seed: 6, numRuns: 200 },
    );
  });

  test('of the layout never changes a byte of the logic', () => {
    fc.assert(
      fc.property(steps(LAYOUT_COMMANDS, 20), (sequence) => {
        const before = start();
        const after = sequence.reduce((project, [name, dice]) => play(LAYOUT_COMMANDS, name, project, dice).project, before);
        expect(saveProject(after).project).toBe(saveProject(before).project);
      }),
      { seed: 2 },
    );
  });
});
