import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import type { GraphNode } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { OpenGraph } from '../editor/document.ts';
import { titleOfName } from '../editor/library.ts';

/** `sepia-k7q2`, within subgraphs `look-a2b3/sepia-k7q2`, with or without `.port`. */
const ADDRESS = /\b([a-z][a-z0-9]*(?:-[a-z0-9]+)+(?:\/[a-z][a-z0-9]*(?:-[a-z0-9]+)+)*)(?:\.([A-Za-z_][A-Za-z0-9_]*))?/g;

const SUBGRAPH = /subgraph “([a-z0-9-]+)”/g;

/**
 * A message with nodes and ports called as the canvas calls them: “Sepia” for `sepia-k7q2`, “Sepia (Amount)” for
 * `sepia-k7q2.amount`. The command line, which shows no canvas, keeps the ids. What is no node of the project stays as it is.
 */
export function plainWords(state: OpenGraph, message: string): string {
  const named = message.replaceAll(SUBGRAPH, (_, name: string) => `subgraph “${titleOfName(name)}”`);
  return named.replaceAll(ADDRESS, (whole, path: string, port: string | undefined) => {
    const node = nodeAt(state, path.slice(path.lastIndexOf('/') + 1));
    if (node === undefined) return whole;
    const face = createInterfaceLookup(state.project, state.library)(node.type);
    if (!face) return port === undefined ? whole : `${path} (${port})`;
    if (port === undefined) return face.title;
    return portWords(face, port);
  });
}

/** “Sepia (Amount)”; “Sepia” where it is the only port on its side, whose name says nothing. */
export function portWords({ title, inputs, outputs, params }: NodeInterface, port: string): string {
  const sides = [outputs, inputs, params] as const;
  const side = sides.find((ports) => getOwn<unknown>(ports, port) !== undefined);
  if (side !== undefined && side !== params && Object.keys(side).length === 1) return title;
  return `${title} (${side?.[port]?.label ?? port})`;
}

export function inPlainWords(state: OpenGraph, diagnostic: Diagnostic): Diagnostic {
  const { message, fix } = diagnostic;
  return { ...diagnostic, message: plainWords(state, message), ...(fix === undefined ? {} : { fix: plainWords(state, fix) }) };
}

/** Ids are unique over all graphs of a project; the open one is the likeliest. */
function nodeAt({ project, graph }: OpenGraph, id: string): GraphNode | undefined {
  const graphs = [getOwn(project.graphs, graph), ...Object.values(project.graphs)];
  return graphs.flatMap((candidate) => (candidate && getOwn(candidate.nodes, id)) ?? [])[0];
}
