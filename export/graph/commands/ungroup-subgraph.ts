import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { makeLayoutId, makeNodeId, subgraphName } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { EMPTY_LAYOUT } from '../new-project.ts';
import type { ExposedPorts, Graph, GraphLayout, GraphNode, NodeLayout, PortAddress, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { routesAfter } from '../routes.ts';
import { printWire, sortWires } from '../wires.ts';
import { type Change, carryRoutes, change, draftGraph, graphOf, type ProjectDraft, refuse, sequence } from './change.ts';
import { draftLayout } from './node-commands.ts';
import { addGraph } from './subgraph-commands.ts';

export interface UngroupSubgraph {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** An instance of a subgraph. */
  readonly node: string;
  readonly random: () => number;
}

/**
 * Replaces an instance of a subgraph by copies of the nodes inside, with the connections and params of the instance. The copies get new
 * ids. The subgraph stays.
 *
 * @returns The change, or a refusal with SCR020 if the node is not an instance of a subgraph.
 * @throws Error if the graph does not exist.
 *
 * @example
 * ungroupSubgraph(project, { library, graph: 'main', node: 'glow-p3m9', random });
 */
export function ungroupSubgraph(project: Project, { library, graph: outer, node: id, random }: UngroupSubgraph): Change {
  const graph = graphOf(project, outer);
  const node = getOwn(graph.nodes, id);
  const name = node && subgraphName(node.type);
  const inner = name ? getOwn(project.graphs, name) : undefined;
  if (!node || !name || !inner) return refuse(project, 'SCR020', `${id} is not a subgraph.`, { nodeId: id });
  const ids = newIds(project, inner, random);
  /** The port inside that a port of the instance exposes; empty if it does not exist. */
  const inside = (side: keyof ExposedPorts, name: string): PortAddress[] =>
    inner.exposed[side].filter((port) => port.name === name).map((port) => renamed(ids, port));
  const at = (side: keyof ExposedPorts, address: PortAddress) => (address.node === id ? inside(side, address.port) : [address]);
  const outerWires = graph.wires.flatMap((wire): [Wire, Wire][] =>
    at('outputs', wire.from).flatMap((from) => at('inputs', wire.to).map((to): [Wire, Wire] => [wire, { from, to }])),
  );
  const wires = outerWires.map(([, wire]) => wire);
  const innerPairs = inner.wires.map((wire): [Wire, Wire] => [wire, { from: renamed(ids, wire.from), to: renamed(ids, wire.to) }]);
  const innerWires = innerPairs.map(([, wire]) => wire);
  const led = underNewReroutes(project, outer, getOwn(project.layout, name), random);
  const shownOn = (side: keyof ExposedPorts) =>
    graph.exposed[side].flatMap(({ name: shown, ...port }) => at(side, port).map((end) => ({ name: shown, ...end })));
  const isShown = graph.exposed.inputs.length + graph.exposed.outputs.length > 0;
  const interfaceOf = createInterfaceLookup(project, library);
  const copies = new Map([...ids].map(([old, copy]) => [copy, getOwn(inner.nodes, old) as GraphNode]));
  for (const flag of ['muted', 'unfused'] as const) {
    if (node[flag] === true) for (const [copy, copied] of copies) copies.set(copy, { ...copied, [flag]: true });
  }
  for (const [name, binding] of Object.entries(node.params)) {
    for (const { node: owner, port } of inside('inputs', name)) {
      const copied = copies.get(owner);
      const isParam = copied && getOwn(interfaceOf(copied.type)?.params ?? {}, port) !== undefined;
      if (isParam) copies.set(owner, { ...copied, params: { ...copied.params, [port]: binding } });
    }
  }
  return change(project, (draft) => {
    const target = draftGraph(draft, outer);
    delete target.nodes[id];
    for (const [copy, node] of copies) target.nodes[copy] = castDraft(node);
    target.wires = castDraft(sortWires([...wires, ...innerWires]));
    if (isShown) target.exposed = castDraft({ inputs: shownOn('inputs'), outputs: shownOn('outputs') });
    carryRoutes(draft, outer, outerWires);
    const by = placeCopies(draft, { outer, id, name, ids });
    const layout = draftLayout(draft, outer);
    for (const [copy, { x, y }] of Object.entries(led.reroutes)) layout.reroutes[copy] = { x: x + by.x, y: y + by.y };
    for (const [wire, copy] of innerPairs) {
      const route = getOwn(led.routes, printWire(wire));
      if (route) layout.routes[printWire(copy)] = [...route];
    }
  });
}

/** The reroutes of a subgraph with ids that are free in the outer graph. */
function underNewReroutes(
  project: Project,
  graph: string,
  inner: GraphLayout = EMPTY_LAYOUT,
  random: () => number,
): Pick<GraphLayout, 'reroutes' | 'routes'> {
  const layout = getOwn(project.layout, graph) ?? EMPTY_LAYOUT;
  const ids = new Map<string, string>();
  let reroutes: GraphLayout['reroutes'] = {};
  for (const [old, place] of Object.entries(inner.reroutes)) {
    const taken = { ...layout, reroutes: { ...layout.reroutes, ...reroutes } };
    const id = makeLayoutId({ layout: { [graph]: taken } }, graph, 'reroute', random);
    ids.set(old, id);
    reroutes = { ...reroutes, [id]: place };
  }
  const routes = Object.entries(inner.routes).map(([wire, route]) => [wire, route.map((id) => ids.get(id) ?? id)]);
  return { reroutes, routes: Object.fromEntries(routes) };
}

/** Places the copies to the right of and below the instance's position, arranged as in the subgraph. Returns their offset. */
function placeCopies(
  draft: ProjectDraft,
  { outer, id, name, ids }: { outer: string; id: string; name: string; ids: ReadonlyMap<string, string> },
): { readonly x: number; readonly y: number } {
  const layout = draftLayout(draft, outer).nodes;
  const places = draft.layout[name]?.nodes ?? {};
  const stood: NodeLayout = layout[id] ?? { x: 0, y: 0 };
  delete layout[id];
  const left = Math.min(...[...ids.keys()].map((old) => places[old]?.x ?? 0));
  const top = Math.min(...[...ids.keys()].map((old) => places[old]?.y ?? 0));
  for (const [old, copy] of ids) {
    const { x, y, ...more }: NodeLayout = places[old] ?? { x: 0, y: 0 };
    layout[copy] = { ...more, x: stood.x + x - left, y: stood.y + y - top };
  }
  return { x: stood.x - left, y: stood.y - top };
}

export interface DuplicateSubgraph {
  readonly from: string;
  readonly to: string;
  readonly random: () => number;
}

/**
 * Copies a subgraph under a new name, for *Make unique*. Its nodes get new ids.
 *
 * @returns The change, or a refusal with SCR020 if the name is invalid or in use.
 * @throws Error if the graph does not exist.
 *
 * @example
 * duplicateSubgraph(project, { from: 'glow', to: 'glow-2', random });
 */
export function duplicateSubgraph(project: Project, { from, to, random }: DuplicateSubgraph): Change {
  const copy = copyOfGraph(project, graphOf(project, from), getOwn(project.layout, from), random);
  return sequence(
    project,
    (before) => addGraph(before, { name: to }),
    (before) =>
      change(before, (draft) => {
        draft.graphs[to] = castDraft(copy.graph);
        draft.layout[to] = castDraft(copy.layout);
      }),
  );
}

/**
 * Copies a graph and its layout under node ids that the project does not use.
 *
 * @example
 * const copy = copyOfGraph(project, graphOf(project, 'glow'), getOwn(project.layout, 'glow'), random);
 */
export function copyOfGraph(
  project: Pick<Project, 'graphs'>,
  graph: Graph,
  layout: GraphLayout = EMPTY_LAYOUT,
  random: () => number,
): { readonly graph: Graph; readonly layout: GraphLayout } {
  const ids = newIds(project, graph, random);
  const shown = (side: keyof ExposedPorts) => graph.exposed[side].map((port) => ({ name: port.name, ...renamed(ids, port) }));
  const wires = graph.wires.map((wire): [Wire, Wire] => [wire, { from: renamed(ids, wire.from), to: renamed(ids, wire.to) }]);
  return {
    graph: {
      nodes: underNewIds(graph.nodes, ids),
      wires: sortWires(wires.map(([, copy]) => copy)),
      exposed: { inputs: shown('inputs'), outputs: shown('outputs') },
    },
    layout: { ...layout, nodes: underNewIds(layout.nodes, ids), routes: routesAfter(layout.routes, wires) },
  };
}

/** New ids, unique among the nodes of all graphs of the project. */
function newIds(project: Pick<Project, 'graphs'>, graph: Graph, random: () => number): ReadonlyMap<string, string> {
  const ids = new Map<string, string>();
  let nodes: Readonly<Record<string, GraphNode>> = {};
  for (const [old, node] of Object.entries(graph.nodes)) {
    const id = makeNodeId({ graphs: { ...project.graphs, ' copies': { ...graph, nodes } } }, node.type, random);
    ids.set(old, id);
    nodes = { ...nodes, [id]: node };
  }
  return ids;
}

function renamed(ids: ReadonlyMap<string, string>, { node, port }: PortAddress): PortAddress {
  return { node: ids.get(node) ?? node, port };
}

function underNewIds<T>(entries: Readonly<Record<string, T>>, ids: ReadonlyMap<string, string>): Record<string, T> {
  return Object.fromEntries(Object.entries(entries).map(([old, entry]) => [ids.get(old) ?? old, entry]));
}
