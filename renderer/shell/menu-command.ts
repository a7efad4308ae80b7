import { type AppCommandId, runCommand } from '../state/app-commands.ts';
import type { Editor } from '../state/editor.ts';
import { isTyping } from './chord.ts';

/** What the browser does to a text field, for commands that a person means for the text there. */
const OF_TEXT: Partial<Record<AppCommandId, string>> = {
  'edit.undo': 'undo',
  'edit.redo': 'redo',
  'edit.delete': 'delete',
  'edit.select-all': 'selectAll',
};

/** A command of the window's own menu. A question that is open goes on waiting for its answer. */
export function runFromMenu(editor: Editor, id: AppCommandId): void {
  const { dialog, palette } = editor.ui.getState();
  const field = document.activeElement;
  const ofText = OF_TEXT[id];
  // The only way to the browser's own list of what was typed. The shader editor keeps a list of its own, out of its reach.
  if (ofText !== undefined && isTyping(field) && field?.closest('[data-typing]') === null) document.execCommand(ofText);
  else if (dialog === null && palette === null) runCommand(editor, id);
}
