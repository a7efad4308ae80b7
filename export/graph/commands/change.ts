import { applyPatches as applyToDraft, castDraft, current, type Draft, enablePatches, type Patch, produceWithPatches } from 'immer';
import { type Diagnostic, type DiagnosticCode, hasErrors } from '../../../nodes/kit/diagnostics.ts';
import type { Graph, Project, Wire } from '../project.ts';
import { getOwn } from '../record.ts';
import { routesAfter } from '../routes.ts';
import { printWire } from '../wires.ts';

/** The result of a command. A refused command returns the same project, no patches and an error with the reason. */
export interface Change {
  readonly project: Project;
  /** Patches from the previous project to the new one. */
  readonly patches: readonly Patch[];
  /** Patches from the new project back to the previous one. */
  readonly inverse: readonly Patch[];
  readonly diagnostics: readonly Diagnostic[];
}

export type ProjectDraft = Draft<Project>;

/** Where a diagnostic belongs. */
export interface Place {
  readonly nodeId?: string;
  readonly port?: string;
  readonly file?: string;
}

/**
 * Records the edits of `recipe` to a draft of the project. Replace lists such as wires as a whole and do not splice them: a splice near the
 * front of ten thousand wires gives ten thousand patches.
 *
 * @returns The changed project, with the patches and the inverse patches.
 *
 * @example
 * change(project, (draft) => {
 *   draft.title = 'Fog';
 * });
 */
export function change(project: Project, recipe: (draft: ProjectDraft) => void): Change {
  enablePatches();
  const [changed, patches, inverse] = produceWithPatches(project, (draft) => {
    recipe(draft);
  });
  return { project: changed, patches, inverse, diagnostics: [] };
}

/**
 * Creates the result of a refused command: the same project, no patches and one error.
 *
 * @param message The problem and its remedy, as text for the user.
 *
 * @example
 * if (name === MAIN_GRAPH) return refuse(project, 'SCR020', 'The main graph cannot be removed.');
 */
export function refuse(project: Project, code: DiagnosticCode, message: string, place: Place = {}): Change {
  return { project, patches: [], inverse: [], diagnostics: [{ code, severity: 'error', ...place, message }] };
}

/**
 * Creates the result of a command that has nothing to do: the same project, no patches.
 *
 * @example
 * if (getOwn(project.sources, file) === text) return unchanged(project);
 */
export function unchanged(project: Project): Change {
  return { project, patches: [], inverse: [], diagnostics: [] };
}

/**
 * Combines several commands into one change. Each command gets the project of the previous one.
 *
 * @returns The combined change. If one command is refused, its errors and the original project.
 *
 * @example
 * sequence(
 *   project,
 *   (before) => addNode(before, node),
 *   (before) => connect(before, wire),
 * );
 */
export function sequence(project: Project, ...steps: readonly ((project: Project) => Change)[]): Change {
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

/** Applies patches of a change, such as the inverse patches for undo. */
export function applyPatches(project: Project, patches: readonly Patch[]): Project {
  enablePatches();
  return applyToDraft(project, patches);
}

/**
 * @returns The graph with this name.
 * @throws Error if the project has no such graph.
 */
export function graphOf(project: Project, name: string): Graph {
  const graph = getOwn(project.graphs, name);
  if (!graph) throw new Error(`Graph "${name}" does not exist.`);
  return graph;
}

export function draftGraph(draft: ProjectDraft, name: string): Draft<Graph> {
  const graph = draft.graphs[name];
  if (!graph) throw new Error(`Graph "${name}" does not exist.`);
  return graph;
}

/** Replaces all wires of a graph. */
export function setWires(draft: ProjectDraft, graph: string, wires: readonly Wire[]): void {
  draftGraph(draft, graph).wires = castDraft(wires);
}

/** Moves the routes of replaced wires to the new wires. */
export function carryRoutes(draft: ProjectDraft, graph: string, replaced: readonly (readonly [before: Wire, after: Wire])[]): void {
  const layout = draft.layout[graph];
  if (layout && replaced.some(([before]) => getOwn(layout.routes, printWire(before)))) {
    layout.routes = castDraft(routesAfter(current(layout).routes, replaced));
  }
}
