import { type AppCommandId, runCommand } from '../state/commands/app-commands.ts';
import { isTyping } from '../state/commands/show-keybinding.ts';
import type { Editor } from '../state/editor/editor.ts';

/** Editing commands of the browser (`execCommand`) that run instead of an app command while a text field has the focus. */
const OF_TEXT: Partial<Record<AppCommandId, string>> = {
  'edit.undo': 'undo',
  'edit.redo': 'redo',
  'edit.delete': 'delete',
  'edit.select-all': 'selectAll',
};

/** Runs a command of the native menu: on a focused text field, or on the project unless a dialog or the palette is open. */
export function runFromMenu(editor: Editor, id: AppCommandId): void {
  const { dialog, palette } = editor.ui.getState();
  const field = document.activeElement;
  const ofText = OF_TEXT[id];
  // `execCommand` is the only access to the undo history of text fields. The shader editor has its own history.
  if (ofText !== undefined && isTyping(field) && field?.closest('[data-typing]') === null) document.execCommand(ofText);
  else if (dialog === null && palette === null) runCommand(editor, id);
}
