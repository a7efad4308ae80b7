import { createInterfaceLookup, type NodeInterface } from '../../../export/graph/library/node-interface.ts';
import { type NodeAddress, replaceNodeAddresses } from '../../../export/graph/node-addresses.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { OpenGraph } from '../editor/document.ts';
import { titleOfName } from '../editor/library.ts';

const SUBGRAPH = /subgraph “([a-z0-9-]+)”/g;

/**
 * Replaces ids in a message by the titles on the canvas: `sepia-k7q2` by “Sepia”, `sepia-k7q2.amount` by “Sepia (Amount)”. Unknown
 * ids stay.
 */
export function withTitles(state: OpenGraph, message: string): string {
  const named = message.replaceAll(SUBGRAPH, (_, name: string) => `subgraph “${titleOfName(name)}”`);
  const interfaceOf = createInterfaceLookup(state.project, state.library);
  const words = ({ node, path, port }: NodeAddress) => {
    const nodeInterface = interfaceOf(node.type);
    if (port === undefined) return nodeInterface?.title ?? path;
    return nodeInterface ? portTitle(nodeInterface, port) : `${path} (${port})`;
  };
  return replaceNodeAddresses(state.project, named, words, state.graph);
}

/** Title of a port: “Sepia (Amount)”, or “Sepia” if it is the only port on its side. */
export function portTitle({ title, inputs, outputs, params }: NodeInterface, port: string): string {
  const sides = [outputs, inputs, params] as const;
  const side = sides.find((ports) => getOwn<unknown>(ports, port) !== undefined);
  if (side !== undefined && side !== params && Object.keys(side).length === 1) return title;
  return `${title} (${side?.[port]?.label ?? port})`;
}

export function diagnosticWithTitles(state: OpenGraph, diagnostic: Diagnostic): Diagnostic {
  const { message, fix } = diagnostic;
  return { ...diagnostic, message: withTitles(state, message), ...(fix === undefined ? {} : { fix: withTitles(state, fix) }) };
}
