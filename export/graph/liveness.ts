import { subgraphName } from './document-names.ts';
import type { Graph, Project } from './project.ts';
import { getOwn } from './record.ts';

/** @returns The nodes of one graph that `roots` depend on, the roots included. */
export function nodesBehind(graph: Graph, roots: Iterable<string>): ReadonlySet<string> {
  const sources = new Map<string, string[]>();
  for (const { from, to } of graph.wires) {
    const list = sources.get(to.node);
    if (list) list.push(from.node);
    else sources.set(to.node, [from.node]);
  }
  const live = new Set<string>();
  for (const root of roots) if (getOwn(graph.nodes, root)) live.add(root);
  // The set grows during the iteration.
  for (const node of live) for (const source of sources.get(node) ?? []) live.add(source);
  return live;
}

/**
 * @returns The ids of the Output nodes of a graph (`output/screen`), sorted.
 *
 * @example
 * screensOf(graph, library); // ['screen-b2c3', 'screen-d4e5']
 */
export function screensOf(
  graph: Pick<Graph, 'nodes'>,
  library: { definition(type: string): { lowering: { kind: string } } | undefined },
): string[] {
  return Object.keys(graph.nodes)
    .filter((id) => library.definition(graph.nodes[id]?.type ?? '')?.lowering.kind === 'present')
    .sort();
}

/** For each graph, the subgraphs that it uses, for walks over all graphs. */
export function usesOfGraphs(project: Pick<Project, 'graphs'>): ReadonlyMap<string, readonly string[]> {
  const uses = new Map<string, string[]>();
  for (const [name, graph] of Object.entries(project.graphs)) {
    const used = new Set<string>();
    for (const node of Object.values(graph.nodes)) {
      const inner = subgraphName(node.type);
      if (inner !== null && getOwn(project.graphs, inner)) used.add(inner);
    }
    uses.set(name, [...used].sort());
  }
  return uses;
}
