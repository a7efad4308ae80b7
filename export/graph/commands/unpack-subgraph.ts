import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { createFaceLookup } from '../library/faces.ts';
import { makeNodeId, subgraphName } from '../names.ts';
import { EMPTY_LAYOUT } from '../new-project.ts';
import { own } from '../own.ts';
import type { ExposedPorts, Graph, GraphLayout, GraphNode, NodeLayout, PortAddress, Project, Wire } from '../project.ts';
import { sortWires } from '../wires.ts';
import { type Change, change, draftGraph, graphOf, inTurn, type ProjectDraft, refuse } from './change.ts';
import { addGraph } from './graphs.ts';
import { draftLayout } from './nodes.ts';

export interface UnpackSubgraph {
  readonly library: NodeLibrary;
  readonly graph: string;
  /** The node that stands for the subgraph. */
  readonly node: string;
  readonly random: () => number;
}

/**
 * Puts what is in a subgraph in the place of a node that stands for it, wired and set as that was. The copies have new ids, and the
 * subgraph stays.
 */
export function unpackSubgraph(project: Project, { library, graph: outer, node: id, random }: UnpackSubgraph): Change {
  const graph = graphOf(project, outer);
  const node = own(graph.nodes, id);
  const name = node && subgraphName(node.type);
  const inner = name ? own(project.graphs, name) : undefined;
  if (!node || !name || !inner) return refuse(project, 'SCR020', `${id} is no subgraph.`, { nodeId: id });
  const ids = newIds(project, inner, random);
  /** The port inside that one of the node stands for; none where it is gone. */
  const inside = (side: keyof ExposedPorts, name: string): PortAddress[] =>
    inner.exposed[side].filter((port) => port.name === name).map((port) => renamed(ids, port));
  const at = (side: keyof ExposedPorts, address: PortAddress) => (address.node === id ? inside(side, address.port) : [address]);
  const wires = graph.wires.flatMap(({ from, to }): Wire[] =>
    at('outputs', from).flatMap((source) => at('inputs', to).map((target) => ({ from: source, to: target }))),
  );
  const innerWires = inner.wires.map(({ from, to }) => ({ from: renamed(ids, from), to: renamed(ids, to) }));
  const shownOn = (side: keyof ExposedPorts) =>
    graph.exposed[side].flatMap(({ name: shown, ...port }) => at(side, port).map((end) => ({ name: shown, ...end })));
  const isShown = graph.exposed.inputs.length + graph.exposed.outputs.length > 0;
  const faceOf = createFaceLookup(project, library);
  const copies = new Map([...ids].map(([old, copy]) => [copy, own(inner.nodes, old) as GraphNode]));
  if (node.muted === true) for (const [copy, copied] of copies) copies.set(copy, { ...copied, muted: true });
  for (const [name, binding] of Object.entries(node.params)) {
    for (const { node: owner, port } of inside('inputs', name)) {
      const copied = copies.get(owner);
      const isParam = copied && own(faceOf(copied.type)?.params ?? {}, port) !== undefined;
      if (isParam) copies.set(owner, { ...copied, params: { ...copied.params, [port]: binding } });
    }
  }
  return change(project, (draft) => {
    const target = draftGraph(draft, outer);
    delete target.nodes[id];
    for (const [copy, node] of copies) target.nodes[copy] = castDraft(node);
    target.wires = castDraft(sortWires([...wires, ...innerWires]));
    if (isShown) target.exposed = castDraft({ inputs: shownOn('inputs'), outputs: shownOn('outputs') });
    placeCopies(draft, { outer, id, name, ids });
  });
}

/** From where the node stood, to the right and down, as they stand in the subgraph. */
function placeCopies(
  draft: ProjectDraft,
  { outer, id, name, ids }: { outer: string; id: string; name: string; ids: ReadonlyMap<string, string> },
): void {
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
}

export interface DuplicateSubgraph {
  readonly from: string;
  readonly to: string;
  readonly random: () => number;
}

/** Another subgraph like one that is there. Its nodes have ids of their own. */
export function duplicateSubgraph(project: Project, { from, to, random }: DuplicateSubgraph): Change {
  const copy = copyOfGraph(project, graphOf(project, from), own(project.layout, from), random);
  return inTurn(
    project,
    (before) => addGraph(before, { name: to }),
    (before) =>
      change(before, (draft) => {
        draft.graphs[to] = castDraft(copy.graph);
        draft.layout[to] = castDraft(copy.layout);
      }),
  );
}

/** A graph and its layout under ids that no node of the project has. */
export function copyOfGraph(
  project: Pick<Project, 'graphs'>,
  graph: Graph,
  layout: GraphLayout | undefined,
  random: () => number,
): { readonly graph: Graph; readonly layout: GraphLayout } {
  const ids = newIds(project, graph, random);
  const shown = (side: keyof ExposedPorts) => graph.exposed[side].map((port) => ({ name: port.name, ...renamed(ids, port) }));
  return {
    graph: {
      nodes: underNewIds(graph.nodes, ids),
      wires: sortWires(graph.wires.map((wire) => ({ from: renamed(ids, wire.from), to: renamed(ids, wire.to) }))),
      exposed: { inputs: shown('inputs'), outputs: shown('outputs') },
    },
    layout: { ...(layout ?? EMPTY_LAYOUT), nodes: underNewIds(layout?.nodes ?? {}, ids) },
  };
}

/** No node of the project, in whatever graph, has the id of another. */
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
