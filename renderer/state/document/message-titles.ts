import type { NodeInterface } from '../../../export/graph/library/node-interface.ts';
import { type NodeAddress, replaceNodeAddresses } from '../../../export/graph/node-addresses.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { OpenGraph } from '../editor/document.ts';
import { titleOfName } from '../editor/library.ts';
import { nodeTitle } from '../editor/node-title.ts';

const SUBGRAPH = /subgraph “([a-z0-9-]+)”/g;

/**
 * Replaces ids in a message by the titles on the canvas: `sepia-k7q2` by “Sepia”, `sepia-k7q2.amount` by “Sepia (Amount)”. Unknown
 * ids stay.
 */
export function withTitles(state: OpenGraph, message: string): string {
  const named = message.replaceAll(SUBGRAPH, (_, name: string) => `subgraph “${titleOfName(name)}”`);
  const words = ({ node, path, port }: NodeAddress) => {
    const definition = state.library.definition(node.type);
    // Messages about a node of an unknown type name the type beside it.
    const title = definition ? nodeTitle(node, state.library, state.project.assets) : path;
    if (port === undefined) return title;
    return definition ? portTitle(title, definition, port) : `${title} (${port})`;
  };
  return replaceNodeAddresses(state.project, named, words, state.graph);
}

/**
 * Title of a port: “Sepia (Amount)”, or “Sepia” if it is the only port on its side.
 *
 * @param title Name of the node.
 */
export function portTitle(title: string, { inputs, outputs, params }: NodeInterface, port: string): string {
  const sides = [outputs, inputs, params] as const;
  const side = sides.find((ports) => getOwn<unknown>(ports, port) !== undefined);
  if (side !== undefined && side !== params && Object.keys(side).length === 1) return title;
  return `${title} (${side?.[port]?.label ?? port})`;
}

export function diagnosticWithTitles(state: OpenGraph, diagnostic: Diagnostic): Diagnostic {
  const { message, fix } = diagnostic;
  return { ...diagnostic, message: withTitles(state, message), ...(fix === undefined ? {} : { fix: withTitles(state, fix) }) };
}
