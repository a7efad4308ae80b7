import type { Editor } from '../editor/editor.ts';
import { revertGesture, undo } from './apply.ts';

/** Cancels a drag of the gizmo and restores the values before it. Late messages of the drag are ignored. */
export function cancelDrag(editor: Editor): void {
  const { gizmo } = editor;
  const { drag, mode } = gizmo.getState();
  if (drag === null) return;
  revertGesture(editor, drag.state);
  // Removing the gizmo ends the drag in the preview.
  gizmo.setState({ drag: null, endedDrag: drag.id, mode: null });
  gizmo.setState({ mode });
}

/** Undoes one step. Cancels a drag of the gizmo instead if the editor has not received its end yet. */
export function undoOrCancelDrag(editor: Editor): void {
  if (editor.gizmo.getState().drag === null) undo(editor);
  else cancelDrag(editor);
}
