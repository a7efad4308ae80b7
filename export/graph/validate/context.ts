import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic, DiagnosticCode } from '../../../nodes/kit/diagnostics.ts';
import type { InterfaceLookup } from '../library/node-interface.ts';
import { type Graph, MAIN_GRAPH, type ProjectLogic } from '../project.ts';

/** The validation of one graph. */
export interface GraphCheck {
  readonly project: ProjectLogic;
  readonly library: NodeLibrary;
  readonly interfaceOf: InterfaceLookup;
  readonly name: string;
  readonly graph: Graph;
  /** Nodes that the output depends on; empty if the output does not depend on the graph. */
  readonly live: ReadonlySet<string>;
  report(diagnostic: Diagnostic): void;
}

export function reportError(
  check: GraphCheck,
  code: DiagnosticCode,
  place: { readonly nodeId?: string; readonly port?: string },
  message: string,
  fix?: string,
): void {
  check.report({ code, severity: 'error', ...place, message: inGraph(check, message), ...(fix === undefined ? {} : { fix }) });
}

/** Reports unfinished work, such as a new node without wires: an error only if the output depends on the node. */
export function reportUnfinished(
  check: GraphCheck,
  code: DiagnosticCode,
  place: { readonly nodeId: string; readonly port: string },
  message: string,
  fix: string,
): void {
  const severity = check.live.has(place.nodeId) ? 'error' : 'warning';
  check.report({ code, severity, ...place, message: inGraph(check, message), fix });
}

/** Adds the name of the subgraph to a sentence. */
export function inGraph({ name }: Pick<GraphCheck, 'name'>, sentence: string): string {
  return name === MAIN_GRAPH ? sentence : `${sentence.replace(/\.$/, '')} (in the subgraph “${name}”).`;
}
