import type { Change } from '../../../export/graph/commands/change.ts';
import { pruneRoutesAfter } from '../../../export/graph/commands/route-commands.ts';
import * as history from '../../../export/graph/history.ts';
import { MAIN_GRAPH, type Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { printWire } from '../../../export/graph/wires.ts';
import { hasErrors } from '../../../nodes/kit/diagnostics.ts';
import { graphOf, layoutOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { placeOfItem } from '../editor/item-ids.ts';
import { keepInSelection } from '../editor/selection.ts';
import { toastDiagnostic } from '../editor/ui.ts';
import { inPlainWords } from './plain-words.ts';

/**
 * Takes over a change as one step of the history; changes with the same `key`, one after the other, are one step until
 * `endGesture`. A refused change is shown with its reason and answers false.
 */
export function apply(editor: Editor, label: string, made: Change, key?: string): boolean {
  const change = pruneRoutesAfter(editor.document.getState().project, made);
  for (const diagnostic of change.diagnostics) toastDiagnostic(editor.ui, inPlainWords(editor.document.getState(), diagnostic));
  if (hasErrors(change.diagnostics)) return false;
  if (change.patches.length === 0) return true;
  const before = editor.document.getState().history;
  takeOver(editor, change.project, history.record(before, change, key === undefined ? { label } : { label, key }));
  return true;
}

/** What follows is a step of its own. */
export function endGesture(editor: Editor): void {
  const before = editor.document.getState().history;
  const after = history.endStep(before);
  if (after !== before) editor.document.setState({ history: after });
}

/** Takes back the gesture under way, which began at that state of the history, as if it had never been. */
export function takeBack(editor: Editor, state: number): void {
  const { history: before, project } = editor.document.getState();
  if (before.past.at(-1)?.before !== state) return;
  const moved = history.undo(before, project);
  if (moved !== null) takeOver(editor, moved.project, { ...moved.history, future: [] });
}

export function undo(editor: Editor): void {
  move(editor, history.undo);
}

export function redo(editor: Editor): void {
  move(editor, history.redo);
}

function move(editor: Editor, step: typeof history.undo): void {
  const { history: before, project } = editor.document.getState();
  const moved = step(before, project);
  if (moved !== null) takeOver(editor, moved.project, moved.history);
}

function takeOver(editor: Editor, project: Project, next: history.History): void {
  editor.document.setState(({ revision, graph, trail }) => ({
    project,
    history: next,
    library: editor.libraries.of(project),
    revision: revision + 1,
    ...stillThere(project, [...trail, graph]),
  }));
  const { nodes, wires } = graphOf(editor.document.getState());
  const ids = new Set(wires.map(printWire));
  const layout = layoutOf(editor.document.getState());
  const exists = {
    node: (id: string) => getOwn(nodes, id) !== undefined,
    wire: (id: string) => ids.has(id),
    item: (id: string) => placeOfItem(layout, id) !== undefined,
  };
  keepInSelection(editor.selection, (kind, id) => exists[kind](id));
}

/** The open graph may be one that an undo takes away: then the nearest on the way to it that is left. */
function stillThere({ graphs }: Project, way: readonly string[]): { readonly graph: string; readonly trail: readonly string[] } {
  const gone = way.findIndex((name) => getOwn(graphs, name) === undefined);
  const left = gone === -1 ? way : way.slice(0, gone);
  return { graph: left.at(-1) ?? MAIN_GRAPH, trail: left.slice(0, -1) };
}
