import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { Diagnostic, DiagnosticCode } from '../../../nodes/kit/diagnostics.ts';
import type { InterfaceLookup } from '../library/node-interface.ts';
import { type Graph, MAIN_GRAPH, type ProjectLogic } from '../project.ts';

/** One graph under examination. */
export interface GraphCheck {
  readonly project: ProjectLogic;
  readonly library: NodeLibrary;
  readonly interfaceOf: InterfaceLookup;
  readonly name: string;
  readonly graph: Graph;
  /** Nodes on which the screen depends; none where it does not depend on the graph. */
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

/**
 * For work in progress: a node just added has no wires yet, and the picture does not depend on it. So it is an error only where
 * the picture does.
 */
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

/** A sentence that says which subgraph it is about. */
export function inGraph({ name }: Pick<GraphCheck, 'name'>, sentence: string): string {
  return name === MAIN_GRAPH ? sentence : `${sentence.replace(/\.$/, '')} (in the subgraph “${name}”).`;
}
