import { takeBack, undo } from '../document/apply.ts';
import type { Editor } from '../editor/editor.ts';

/** Ends a drag of the gizmo and restores the values before it. Messages of it that the preview has sent already are ignored. */
export function cancelDrag(editor: Editor): void {
  const { gizmo } = editor;
  const { drag, mode } = gizmo.getState();
  if (drag === null) return;
  takeBack(editor, drag.state);
  // A preview without a gizmo ends its drag.
  gizmo.setState({ drag: null, endedDrag: drag.id, mode: null });
  gizmo.setState({ mode });
}

/** Undoes one step. A drag of the gizmo, in progress or just released in the preview, is canceled instead. */
export function undoOrCancelDrag(editor: Editor): void {
  if (editor.gizmo.getState().drag === null) undo(editor);
  else cancelDrag(editor);
}
