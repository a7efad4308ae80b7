import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import type { GraphNode } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { OpenGraph } from '../editor/document.ts';
import { titleOfName } from '../editor/library.ts';

/** Matches node ids such as `sepia-k7q2` or `look-a2b3/sepia-k7q2`, with or without `.port`. */
const ADDRESS = /\b([a-z][a-z0-9]*(?:-[a-z0-9]+)+(?:\/[a-z][a-z0-9]*(?:-[a-z0-9]+)+)*)(?:\.([A-Za-z_][A-Za-z0-9_]*))?/g;

const SUBGRAPH = /subgraph “([a-z0-9-]+)”/g;

/**
 * Replaces ids in a message by the titles on the canvas: `sepia-k7q2` by “Sepia”, `sepia-k7q2.amount` by “Sepia (Amount)”. Unknown
 * ids stay. The command line has no canvas and keeps the ids.
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

/** Title of a port: “Sepia (Amount)”, or “Sepia” if it is the only port on its side. */
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

/** Finds a node by id, first in the open graph. Ids are unique in a project. */
function nodeAt({ project, graph }: OpenGraph, id: string): GraphNode | undefined {
  const graphs = [getOwn(project.graphs, graph), ...Object.values(project.graphs)];
  return graphs.flatMap((candidate) => (candidate && getOwn(candidate.nodes, id)) ?? [])[0];
}
