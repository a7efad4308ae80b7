import { applyPatches as applyToDraft, castDraft, current, type Draft, enablePatches, type Patch, produceWithPatches } from 'immer';
import { type Diagnostic, type DiagnosticCode, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Graph, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { routesAfter } from '../routes.ts';
import { printWire } from '../wires.ts';

/** The result of a command. A refused command returns the same project, no patches and an error with the reason. */
export interface Change {
  readonly project: Project;
  /** From the project before to the one after. */
  readonly patches: readonly Patch[];
  /** From the project after back to the one before. */
  readonly inverse: readonly Patch[];
  readonly diagnostics: readonly Diagnostic[];
}

export type ProjectDraft = Draft<Project>;

/** What a diagnostic is about. */
export interface Place {
  readonly nodeId?: string;
  readonly port?: string;
  readonly file?: string;
}

/**
 * Records the edits of `recipe` to a draft of the project. Replace lists (wires, exposed ports) as a whole and never splice them:
 * a splice near the front of ten thousand wires gives ten thousand patches.
 *
 * @returns The changed project, with the patches and the inverse patches.
 */
export function change(project: Project, recipe: (draft: ProjectDraft) => void): Change {
  enablePatches();
  const [changed, patches, inverse] = produceWithPatches(project, (draft) => {
    recipe(draft);
  });
  return { project: changed, patches, inverse, diagnostics: [] };
}

export function refuse(project: Project, code: DiagnosticCode, message: string, place: Place = {}): Change {
  return { project, patches: [], inverse: [], diagnostics: [{ code, severity: 'error', ...place, message }] };
}

export function unchanged(project: Project): Change {
  return { project, patches: [], inverse: [], diagnostics: [] };
}

/**
 * Combines several changes into one step. Each works on the result of the previous one.
 *
 * @returns The combined change; where one step is refused, the whole is, and the project stays as it is.
 * @example
 * inTurn(project, (before) => addNode(before, node), (before) => connect(before, wire));
 */
export function inTurn(project: Project, ...steps: readonly ((project: Project) => Change)[]): Change {
  let sum = unchanged(project);
  for (const step of steps) {
    const next = step(sum.project);
    if (hasErrors(next.diagnostics)) return { ...unchanged(project), diagnostics: next.diagnostics };
    sum = {
      project: next.project,
      patches: [...sum.patches, ...next.patches],
      inverse: [...next.inverse, ...sum.inverse],
      diagnostics: [...sum.diagnostics, ...next.diagnostics],
    };
  }
  return sum;
}

export function applyPatches(project: Project, patches: readonly Patch[]): Project {
  enablePatches();
  return applyToDraft(project, patches);
}

/** The graph that the editor shows, so it exists: another name is a programmer's mistake. */
export function graphOf(project: Project, name: string): Graph {
  const graph = getOwn(project.graphs, name);
  if (!graph) throw new Error(`There is no graph "${name}".`);
  return graph;
}

export function draftGraph(draft: ProjectDraft, name: string): Draft<Graph> {
  const graph = draft.graphs[name];
  if (!graph) throw new Error(`There is no graph "${name}".`);
  return graph;
}

/** Replaces the wires, unless they are the ones it has. */
export function setWires(draft: ProjectDraft, graph: string, wires: readonly Wire[]): void {
  draftGraph(draft, graph).wires = castDraft(wires);
}

/** Wires that have become others keep their ways. */
export function carryRoutes(draft: ProjectDraft, graph: string, replaced: readonly (readonly [before: Wire, after: Wire])[]): void {
  const layout = draft.layout[graph];
  if (layout && replaced.some(([before]) => getOwn(layout.routes, printWire(before)))) {
    layout.routes = castDraft(routesAfter(current(layout).routes, replaced));
  }
}
