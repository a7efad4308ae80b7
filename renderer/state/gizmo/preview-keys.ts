import { appCommand, appCommandIds, runCommand } from '../commands/app-commands.ts';
import { commandOfKeybinding, keybindingsOf } from '../commands/keybindings.ts';
import type { Editor } from '../editor/editor.ts';

/** Keybindings that run commands while the preview has the focus. Tab moves the focus. */
export function previewKeybindings(editor: Editor): string[] {
  const keybindings = appCommandIds().flatMap((id) => (appCommand(id).byEvent === true ? [] : keybindingsOf(editor, id)));
  return keybindings.filter((keybinding) => keybinding !== 'Tab');
}

/** Runs the command of a key that was pressed in the preview. */
export function runPreviewKey(editor: Editor, keybinding: string): void {
  const { dialog, palette } = editor.ui.getState();
  if (dialog !== null || palette !== null) return;
  // The preview has no timeline, so keys of the gizmo take precedence over those of the timeline.
  const plain = commandOfKeybinding(editor, keybinding, false);
  const id = plain?.startsWith('gizmo.') ? plain : commandOfKeybinding(editor, keybinding, false, 'time');
  if (id !== null) runCommand(editor, id);
}
