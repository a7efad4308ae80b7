import { castDraft } from 'immer';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import { subgraphType } from '../document-names.ts';
import { createInterfaceLookup } from '../library/node-interface.ts';
import { EMPTY_LAYOUT } from '../new-project.ts';
import type { ExposedPort, ExposedPorts, Graph, GraphLayout, PortAddress, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { pruneRoutes } from '../routes.ts';
import { sameAddress, sortWires } from '../wires.ts';
import { type Change, carryRoutes, change, draftGraph, graphOf, refuse, sequence } from './change.ts';
import { addNode, draftLayout } from './node-commands.ts';
import { addGraph } from './subgraph-commands.ts';

export interface CreateSubgraph {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly nodes: readonly string[];
  /** Name of the new subgraph. */
  readonly name: string;
  /** Id of the subgraph's instance, from `makeNodeId`. */
  readonly id: string;
  /** Position of the instance, canvas units. */
  readonly x: number;
  readonly y: number;
}

/**
 * Moves nodes into a new subgraph and replaces them by one instance of it. Ports with a wire to a node outside are exposed, so that the
 * render stays the same. The nodes keep their ids.
 *
 * @returns The change, or a refusal: SCR020 if there are no nodes, one is an output or the name is invalid; SCR014 if a node outside is
 * between them.
 * @throws Error if the graph does not exist.
 *
 * @example
 * const id = makeNodeId(project, 'graph/glow', random);
 * createSubgraph(project, { library, graph: 'main', nodes: ['blur-x7k2', 'add-p3m9'], name: 'glow', id, x: 240, y: 80 });
 */
export function createSubgraph(project: Project, { library, graph: outerName, nodes, name, id, x, y }: CreateSubgraph): Change {
  const graph = graphOf(project, outerName);
  const chosen = new Set(nodes.filter((node) => getOwn(graph.nodes, node)));
  if (chosen.size === 0) return refuse(project, 'SCR020', 'No node is selected. Select the nodes for the subgraph.');
  const screen = [...chosen].find((node) => library.definition(getOwn(graph.nodes, node)?.type ?? '')?.lowering.kind === 'present');
  if (screen !== undefined) {
    return refuse(project, 'SCR020', `${screen} must stay in the main graph. Leave it out of the subgraph.`, { nodeId: screen });
  }
  const between = nodeBetween(graph, chosen);
  if (between !== null) {
    const message = `${between} lies between the nodes of the subgraph. Include it, or connect around it.`;
    return refuse(project, 'SCR014', message, { nodeId: between });
  }
  const shown = portsShown(graph, chosen);
  /** The port of the instance that exposes a port inside. */
  const outside = (side: keyof ExposedPorts, address: PortAddress): PortAddress => {
    const port = shown[side].find((candidate) => sameAddress(candidate, address));
    return port ? { node: id, port: port.name } : address;
  };
  const isInner = ({ from, to }: Wire) => chosen.has(from.node) && chosen.has(to.node);
  const outer = graph.wires
    .filter((wire) => !isInner(wire))
    .map((wire) => [wire, { from: outside('outputs', wire.from), to: outside('inputs', wire.to) }] as const);
  const wires = outer.map(([, wire]) => wire);
  const showOn = (side: keyof ExposedPorts) => graph.exposed[side].map((port) => ({ name: port.name, ...outside(side, port) }));
  const exposed = { inputs: showOn('inputs'), outputs: showOn('outputs') };

  return sequence(
    project,
    (before) => addGraph(before, { name }),
    (before) =>
      change(before, (draft) => {
        const old = draftGraph(draft, outerName);
        const places = draftLayout(draft, outerName).nodes;
        draft.graphs[name] = castDraft(graphWithin(graph, chosen, shown));
        draft.layout[name] = castDraft(layoutWithin(getOwn(project.layout, outerName), graph.wires.filter(isInner), chosen));
        for (const node of chosen) {
          delete old.nodes[node];
          delete places[node];
        }
        // The routes are moved before the instance exists, because its wires depend on it.
        carryRoutes(draft, outerName, outer);
        old.wires = castDraft(wires.filter(({ from, to }) => from.node !== id && to.node !== id));
      }),
    (before) => addNode(before, { library, graph: outerName, id, type: subgraphType(name), x, y }),
    (before) =>
      change(before, (draft) => {
        const nodeInterface = createInterfaceLookup(before, library)(subgraphType(name));
        const now = draftGraph(draft, outerName);
        now.wires = castDraft(sortWires(wires));
        if (exposed.inputs.length + exposed.outputs.length > 0) now.exposed = castDraft(exposed);
        const params = now.nodes[id]?.params;
        for (const { to } of wires) {
          const param = to.node === id ? getOwn(nodeInterface?.params ?? {}, to.port) : undefined;
          if (params && param) params[to.port] = castDraft({ port: param.default });
        }
      }),
  );
}

/**
 * The ports that the subgraph must expose: ports of the selected nodes that are connected to other nodes or already exposed, each with the
 * name of its port.
 */
function portsShown({ wires, exposed }: Graph, chosen: ReadonlySet<string>): ExposedPorts {
  const isIn = ({ node }: PortAddress) => chosen.has(node);
  const inputs = wires.filter(({ from, to }) => !isIn(from) && isIn(to)).map(({ to }) => to);
  const outputs = wires.filter(({ from, to }) => isIn(from) && !isIn(to)).map(({ from }) => from);
  const taken = new Set<string>();
  const named = (addresses: readonly PortAddress[]): ExposedPort[] => {
    const ports: ExposedPort[] = [];
    for (const { node, port } of addresses) {
      if (ports.some((known) => sameAddress(known, { node, port }))) continue;
      let name = port;
      for (let number = 2; taken.has(name); number++) name = `${port}${number}`;
      taken.add(name);
      ports.push({ name, node, port });
    }
    return ports;
  };
  return { inputs: named([...inputs, ...exposed.inputs.filter(isIn)]), outputs: named([...outputs, ...exposed.outputs.filter(isIn)]) };
}

function graphWithin(graph: Graph, chosen: ReadonlySet<string>, exposed: ExposedPorts): Graph {
  return {
    nodes: Object.fromEntries(Object.entries(graph.nodes).filter(([id]) => chosen.has(id))),
    wires: graph.wires.filter(({ from, to }) => chosen.has(from.node) && chosen.has(to.node)),
    exposed,
  };
}

/** Positions of the nodes and routes of the wires between them. */
function layoutWithin(layout: GraphLayout = EMPTY_LAYOUT, wires: readonly Wire[], chosen: ReadonlySet<string>): GraphLayout {
  const nodes = Object.fromEntries(Object.entries(layout.nodes).filter(([id]) => chosen.has(id)));
  return pruneRoutes({ wires }, { ...EMPTY_LAYOUT, nodes, reroutes: layout.reroutes, routes: layout.routes });
}

/** A node that is not selected, but on a path between selected nodes: outside, it would close a loop. Null if there is none. */
function nodeBetween({ wires }: Graph, chosen: ReadonlySet<string>): string | null {
  const reached = (ends: (wire: Wire) => readonly [from: string, to: string]): Set<string> => {
    const followers = new Map<string, string[]>();
    for (const [from, to] of wires.map(ends)) followers.set(from, [...(followers.get(from) ?? []), to]);
    const found = new Set<string>();
    const spread = (node: string) => followers.get(node)?.forEach((next) => void (chosen.has(next) || found.add(next)));
    for (const node of chosen) spread(node);
    // The set grows during the iteration.
    for (const node of found) spread(node);
    return found;
  };
  const after = reached(({ from, to }) => [from.node, to.node]);
  const before = reached(({ from, to }) => [to.node, from.node]);
  return [...after].find((node) => before.has(node)) ?? null;
}
