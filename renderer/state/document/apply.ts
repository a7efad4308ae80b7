import type { Change } from '../../../export/graph/commands/change.ts';
import { pruneRoutesAfter } from '../../../export/graph/commands/route-commands.ts';
import * as history from '../../../export/graph/history.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { type DocumentState, graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { borderOf, placeOfItem } from '../editor/item-ids.ts';
import { keepInSelection } from '../editor/selection.ts';
import { revealNodes, toastDiagnostic } from '../editor/ui.ts';
import { diagnosticWithTitles } from './message-titles.ts';

/**
 * Applies a change as one undo step. Successive changes with the same `key` form one step until `endGesture`. If the change has
 * errors, shows them and returns false.
 */
export function apply(editor: Editor, label: string, made: Change, key?: string): boolean {
  const change = pruneRoutesAfter(editor.document.getState().project, made);
  for (const diagnostic of change.diagnostics) toastDiagnostic(editor.ui, diagnosticWithTitles(editor.document.getState(), diagnostic));
  if (hasErrors(change.diagnostics)) return false;
  if (change.patches.length === 0) return true;
  const before = editor.document.getState();
  commit(editor, change.project, history.record(before.history, change, key === undefined ? { label } : { label, key }));
  showAdded(editor, before);
  return true;
}

/** The undo step of a change that is part of a larger one. Default: a step of its own, with its own label. */
export type AddStep = Partial<history.StepOptions>;

/** Scrolls to the nodes that a change has added to the open graph. */
function showAdded(editor: Editor, before: DocumentState): void {
  const known = graphOf(before).nodes;
  const { nodes } = graphOf(editor.document.getState());
  const added = nodes === known ? [] : Object.keys(nodes).filter((id) => getOwn(known, id) === undefined);
  if (added.length > 0) revealNodes(editor.ui, added);
}

/** Ends the current undo step. The next change starts another one. */
export function endGesture(editor: Editor): void {
  const before = editor.document.getState().history;
  const after = history.endStep(before);
  if (after !== before) editor.document.setState({ history: after });
}

/** Reverts the gesture in progress, without a redo step. `state` is the state of the history before it. */
export function revertGesture(editor: Editor, state: number): void {
  const { history: before, project } = editor.document.getState();
  if (before.past.at(-1)?.before !== state) return;
  const moved = history.undo(before, project);
  if (moved !== null) commit(editor, moved.project, { ...moved.history, future: [] });
}

export function undo(editor: Editor): void {
  move(editor, history.undo);
}

export function redo(editor: Editor): void {
  move(editor, history.redo);
}

/** The steps of the history: first those that can be undone, then those that can be redone, in the order in which they were made. */
export function historySteps({ past, future }: history.History): readonly history.HistoryStep[] {
  return [...past, ...future];
}

/**
 * Undoes or redoes until exactly the first `count` steps of `historySteps` are done. One change of the document.
 *
 * @param count From 0 (as opened) to the number of steps.
 */
export function goToStep(editor: Editor, count: number): void {
  const state = editor.document.getState();
  const moved = atStep(state, count);
  if (moved.history === state.history) return;
  commit(editor, moved.project, moved.history);
  findGraph(editor);
}

/** The project as `goToStep` would show it. */
export function projectAtStep(state: Pick<DocumentState, 'history' | 'project'>, count: number): Project {
  return atStep(state, count).project;
}

function atStep({ history: before, project }: Pick<DocumentState, 'history' | 'project'>, count: number): history.Moved {
  let moved: history.Moved = { history: before, project };
  while (moved.history.past.length !== count) {
    const step = moved.history.past.length > count ? history.undo : history.redo;
    const next = step(moved.history, moved.project);
    if (next === null) break;
    moved = next;
  }
  return moved;
}

/** The number of steps that the last save contains; null if no undo or redo leads there. */
export function savedStep({ history: { past, future, state }, savedState }: Pick<DocumentState, 'history' | 'savedState'>): number | null {
  if (state === savedState) return past.length;
  const steps = [...past, ...future];
  if (steps[0]?.before === savedState) return 0;
  const index = steps.findIndex(({ after }) => after === savedState);
  return index === -1 ? null : index + 1;
}

function move(editor: Editor, step: typeof history.undo): void {
  const { history: before, project } = editor.document.getState();
  const moved = step(before, project);
  if (moved === null) return;
  commit(editor, moved.project, moved.history);
  findGraph(editor);
}

/** Shows the graph again where the view is left with nothing of it, as after the undo of a drop to which the view had moved. */
function findGraph({ ui }: Editor): void {
  revealNodes(ui, [], 'find');
}

function commit(editor: Editor, project: Project, next: history.History): void {
  editor.document.setState(({ revision, graph, trail }) => ({
    project,
    history: next,
    library: editor.libraries.of(project),
    revision: revision + 1,
    ...nearestExisting(project, [...trail, graph]),
  }));
  const { nodes, wires } = graphOf(editor.document.getState());
  const ids = new Set(wires.map(printWire));
  const layout = layoutOf(editor.document.getState());
  const exists = {
    node: (id: string) => getOwn(nodes, id) !== undefined,
    wire: (id: string) => ids.has(id),
    item: (id: string) => placeOfItem(layout, id) !== undefined || borderOf(id) !== null,
  };
  keepInSelection(editor.selection, (kind, id) => exists[kind](id));
}

/** The open graph if it still exists after an undo; else its nearest existing ancestor. */
function nearestExisting({ graphs }: Project, path: readonly string[]): { readonly graph: string; readonly trail: readonly string[] } {
  const gone = path.findIndex((name) => getOwn(graphs, name) === undefined);
  const left = gone === -1 ? path : path.slice(0, gone);
  return { graph: left.at(-1) ?? MAIN_GRAPH, trail: left.slice(0, -1) };
}
