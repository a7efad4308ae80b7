import type { MenuItem } from '../../ui/menu.tsx';
import type { Editor } from '../editor/editor.ts';
import { type AppCommandId, appCommand, runCommand } from './app-commands.ts';
import { keybindingsOf } from './keybindings.ts';
import { showKeybinding } from './show-keybinding.ts';

/** A command as menus have it now, with the person's keys. */
export function commandItem(editor: Editor, id: AppCommandId): Extract<MenuItem, { kind: 'action' }> {
  const { label, enabled } = appCommand(id);
  const keys = shownKeys(editor, id);
  return {
    kind: 'action',
    label,
    ...(keys === undefined ? {} : { keys }),
    disabled: !enabled(editor),
    run: () => runCommand(editor, id),
  };
}

/** The first keys of a command, as menus and tooltips show them; undefined where it has none. */
export function shownKeys(editor: Pick<Editor, 'preferences' | 'mac'>, id: AppCommandId): string | undefined {
  const [keybinding] = keybindingsOf(editor, id);
  return keybinding === undefined ? undefined : showKeybinding(keybinding, editor.mac);
}
