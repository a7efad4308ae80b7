import { type GraphNode, MAIN_GRAPH, type Project } from './project.ts';
import { getOwn } from './record.ts';

/**
 * Matches the address of a node in a text: `sepia-k7q2`, inside subgraphs `look-a2b3/sepia-k7q2`, with or without `.port`; not the file
 * `shaders/sepia-k7q2.fs`.
 */
const ADDRESS = /(?<![\w/])([a-z][a-z0-9]*(?:-[a-z0-9]+)+(?:\/[a-z][a-z0-9]*(?:-[a-z0-9]+)+)*)(?:\.([A-Za-z_][A-Za-z0-9_]*))?/g;

export interface NodeAddress {
  readonly node: GraphNode;
  /** The id of the node after the ids of the subgraphs' instances around it: `look-a2b3/sepia-k7q2`. */
  readonly path: string;
  readonly port: string | undefined;
}

/**
 * Replaces the addresses of nodes and ports in a message. Words that only look like ids stay as they are.
 *
 * @param graph The graph that is searched first. Ids are unique in all graphs of a project.
 *
 * @example
 * replaceNodeAddresses(project, 'Input of sepia-k7q2.', ({ node }) => node.type); // 'Input of filter/sepia.'
 */
export function replaceNodeAddresses(
  { graphs }: Pick<Project, 'graphs'>,
  message: string,
  replace: (address: NodeAddress) => string,
  graph: string = MAIN_GRAPH,
): string {
  const searched = [getOwn(graphs, graph), ...Object.values(graphs)];
  return message.replaceAll(ADDRESS, (whole, path: string, port: string | undefined) => {
    const id = path.slice(path.lastIndexOf('/') + 1);
    const [node] = searched.flatMap((candidate) => (candidate && getOwn(candidate.nodes, id)) ?? []);
    return node === undefined ? whole : replace({ node, path, port });
  });
}
