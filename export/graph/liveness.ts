import { subgraphName } from './names.ts';
import { own } from './own.ts';
import type { Graph, Project } from './project.ts';

/** Nodes of one graph from which a wire leads to `roots`, these included. */
export function nodesBehind(graph: Graph, roots: Iterable<string>): ReadonlySet<string> {
  const sources = new Map<string, string[]>();
  for (const { from, to } of graph.wires) {
    const list = sources.get(to.node);
    if (list) list.push(from.node);
    else sources.set(to.node, [from.node]);
  }
  const live = new Set<string>();
  for (const root of roots) if (own(graph.nodes, root)) live.add(root);
  // The set grows while it is walked.
  for (const node of live) for (const source of sources.get(node) ?? []) live.add(source);
  return live;
}

/** Nodes that show the visitor something: they lower to what is on screen. */
export function screensOf(
  graph: Pick<Graph, 'nodes'>,
  library: { definition(type: string): { lowering: { kind: string } } | undefined },
): string[] {
  return Object.keys(graph.nodes)
    .filter((id) => library.definition(graph.nodes[id]?.type ?? '')?.lowering.kind === 'present')
    .sort();
}

/** Subgraphs by the names of those that use them, for the walk over all graphs. */
export function usesOfGraphs(project: Pick<Project, 'graphs'>): ReadonlyMap<string, readonly string[]> {
  const uses = new Map<string, string[]>();
  for (const [name, graph] of Object.entries(project.graphs)) {
    const used = new Set<string>();
    for (const node of Object.values(graph.nodes)) {
      const inner = subgraphName(node.type);
      if (inner !== null && own(project.graphs, inner)) used.add(inner);
    }
    uses.set(name, [...used].sort());
  }
  return uses;
}
