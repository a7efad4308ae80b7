import { subgraphName } from '../../graph/document-names.ts';
import { type ExposedPort, type Graph, type GraphNode, MAIN_GRAPH, type PortAddress, type ProjectLogic } from '../../graph/project.ts';
import { getOwn, sortedEntries } from '../../graph/record.ts';

/** One use of a graph: the main graph, or a subgraph in place of a node. */
export interface Instance {
  /** Prefix of the ids of its nodes: empty, or `outer/`. */
  readonly prefix: string;
  readonly graph: Graph;
  /** Whether fusion is turned off for all nodes in it. */
  readonly unfused: boolean;
  /** Instances that replace its nodes, by node id. */
  readonly children: Map<string, Instance>;
}

/** A port of a node that is not a subgraph. */
export interface Place {
  readonly node: string;
  readonly port: string;
}

/**
 * Maximum number of nodes after inlining. A few nested subgraphs that each use the next one twice give any number of nodes; the limit
 * protects the editor and servers against such files. This many compile in about 4 s to a program of 35 MB.
 */
export const MAX_FLAT_NODES = 40_000;

export type Instances = { readonly ok: true; readonly list: readonly Instance[] } | { readonly ok: false };

/**
 * Lists all uses of graphs, each before those inside it. `ok` is false if there are more nodes than `MAX_FLAT_NODES`. Subgraphs must not be
 * recursive.
 */
export function listInstances(project: ProjectLogic): Instances {
  const main = getOwn(project.graphs, MAIN_GRAPH);
  const list: Instance[] = main ? [{ prefix: '', graph: main, unfused: false, children: new Map() }] : [];
  let count = 0;
  // The list grows during the iteration.
  for (const instance of list) {
    for (const [id, node] of sortedEntries(instance.graph.nodes)) {
      count++;
      // A muted subgraph is bypassed as a whole, like any node.
      const graph = node.muted === true ? undefined : subgraphOf(project, node);
      if (!graph) continue;
      const unfused = instance.unfused || node.unfused === true;
      const child: Instance = { prefix: `${instance.prefix}${id}/`, graph, unfused, children: new Map() };
      instance.children.set(id, child);
      list.push(child);
    }
    if (count > MAX_FLAT_NODES) return { ok: false };
  }
  return { ok: true, list };
}

function subgraphOf(project: ProjectLogic, node: GraphNode): Graph | undefined {
  const name = subgraphName(node.type);
  return name === null ? undefined : getOwn(project.graphs, name);
}

/** Finds the port inside that an exposed port refers to, through nested subgraphs; null if it does not exist. */
export type InnerPortLookup = (instance: Instance, address: PortAddress) => Place | null;

/** Creates a lookup that caches the exposed ports of each graph by name. */
export function createInnerPortLookup(side: 'inputs' | 'outputs'): InnerPortLookup {
  const shown = new Map<Graph, ReadonlyMap<string, ExposedPort>>();
  const shownBy = (graph: Graph): ReadonlyMap<string, ExposedPort> => {
    const known = shown.get(graph) ?? new Map(graph.exposed[side].map((port) => [port.name, port]));
    shown.set(graph, known);
    return known;
  };
  return (start, address) => {
    let instance = start;
    let at = address;
    for (let child = instance.children.get(at.node); child; child = instance.children.get(at.node)) {
      const next = shownBy(child.graph).get(at.port);
      if (!next) return null;
      instance = child;
      at = next;
    }
    return getOwn(instance.graph.nodes, at.node) ? { node: instance.prefix + at.node, port: at.port } : null;
  };
}
