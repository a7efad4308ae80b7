import { uniqueDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { isChunkFile } from '../../../export/graph/document-names.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { shaderOf, vertexOf } from '../document/edit-shader.ts';
import { type DocumentState, graphOf, nodeOf, type OpenGraph } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { revealCode } from '../editor/ui.ts';
import { goToNode, type NodePlace, pathToGraph, placeOnPath } from '../graph/graph-path.ts';

export interface NodeProblem {
  readonly severity: Diagnostic['severity'];
  /** All messages, one per line. */
  readonly text: string;
}

const RANK = { error: 0, warning: 1, info: 2 } as const;

/** Merges lists of diagnostics, drops duplicates, and sorts by severity; those of one file by line. */
export function collectProblems(lists: readonly (readonly Diagnostic[])[]): readonly Diagnostic[] {
  const seen = new Map<string, Diagnostic>();
  for (const diagnostic of lists.flat()) {
    const key = problemKey(diagnostic);
    if (!seen.has(key)) seen.set(key, diagnostic);
  }
  return uniqueDiagnostics([...seen.values()]).sort((a, b) => RANK[a.severity] - RANK[b.severity]);
}

/**
 * Those of `problems` that are also in `before`. Used while a text is being typed: new problems are hidden, but fixed ones disappear at
 * once.
 */
export function stillWrong(problems: readonly Diagnostic[], before: readonly Diagnostic[]): readonly Diagnostic[] {
  const known = new Set(before.map(problemKey));
  return problems.filter((problem) => known.has(problemKey(problem)));
}

export function problemKey({ code, nodeId, port, file, line, column, message }: Diagnostic): string {
  return JSON.stringify([code, nodeId, port, file, line, column, message]);
}

/** Whether a problem belongs to a node: it names the node, or only the file of its shader. */
export function isAboutNode({ nodeId, file }: Diagnostic, state: OpenGraph, id: string): boolean {
  return nodeId === undefined ? isAboutFileOf(state, id, file) : nodeHere(state, nodeId) === id;
}

function isAboutFileOf(state: OpenGraph, id: string, file: string | undefined): boolean {
  return file !== undefined && (shaderOf(state, id)?.name === file || vertexOf(state, id) === file);
}

export function problemsByNode(problems: readonly Diagnostic[], state: OpenGraph): ReadonlyMap<string, NodeProblem> {
  const byNode = new Map<string, NodeProblem>();
  for (const problem of problems) {
    const ids =
      problem.nodeId === undefined
        ? Object.keys(graphOf(state).nodes).filter((id) => isAboutNode(problem, state, id))
        : [nodeHere(state, problem.nodeId) ?? problem.nodeId];
    for (const id of ids) {
      const known = byNode.get(id);
      // The list is sorted, so the first problem has the highest severity.
      const { severity, message } = problem;
      byNode.set(id, known ? { severity: known.severity, text: `${known.text}\n${message}` } : { severity, text: message });
    }
  }
  return byNode;
}

export function countProblems(problems: readonly Diagnostic[]): Readonly<Record<Diagnostic['severity'], number>> {
  const count = { error: 0, warning: 0, info: 0 };
  for (const { severity } of problems) count[severity]++;
  return count;
}

/** Selects and shows the node of a problem, in any graph. Opens its shader at the line, if there is one. */
export function goToProblem(editor: Editor, problem: Diagnostic): void {
  const place = placeOfProblem(editor.document.getState(), problem);
  if (place === null) return;
  goToNode(editor, place);
  if (problem.line !== undefined && shaderOf(editor.document.getState(), place.node) !== null)
    revealCode(editor.ui, problem.line, problem.column ?? 1, otherFileIn(problem));
}

/** Whether a problem has a node to go to. */
export function canGoToProblem({ document }: Pick<Editor, 'document'>, problem: Diagnostic): boolean {
  return placeOfProblem(document.getState(), problem) !== null;
}

/** The node of the open graph that a path in the program (`look-a2b3/sepia-k7q2`) refers to or lies in. */
function nodeHere(state: OpenGraph, path: string): string | undefined {
  return path.split('/').find((id) => nodeOf(state, id) !== undefined);
}

/** Finds the node of a problem: the one that it names; else the first that uses its file, in the open graph first. */
function placeOfProblem(state: DocumentState, { nodeId, file }: Diagnostic): NodePlace | null {
  const { project, graph, trail } = state;
  const named = nodeId === undefined ? null : placeOnPath(project, nodeId);
  if (named !== null) return named;
  const isIt = (name: string, id: string) => (nodeId === undefined ? isAboutFileOf({ ...state, graph: name }, id, file) : id === nodeId);
  for (const name of [graph, ...Object.keys(project.graphs)]) {
    const node = Object.keys(graphOf({ project, graph: name }).nodes).find((id) => isIt(name, id));
    if (node !== undefined) return { graph: name, trail: name === graph ? trail : pathToGraph(project, name), node };
  }
  return null;
}

/** The chunk or vertex shader of a problem, which is reported at a node that uses it; null for the shader of the node. */
function otherFileIn({ file }: Diagnostic): string | null {
  return file !== undefined && (isChunkFile(file) || file.endsWith('.vs')) ? file : null;
}
