import { useStore } from 'zustand';
import type { MenuItem } from '../../ui/menu.tsx';
import type { Editor } from '../editor/editor.ts';
import { useEditor } from '../editor/editor-context.ts';
import { type AppCommandId, appCommand, runCommand } from './app-commands.ts';
import { tickOf } from './command-ticks.ts';
import { keybindingsOf } from './keybindings.ts';
import { showKeybinding } from './show-keybinding.ts';

/** The menu item of a command in its current state, with its keys. */
export function commandItem(editor: Editor, id: AppCommandId): Extract<MenuItem, { kind: 'action' }> {
  const { label, enabled } = appCommand(id);
  const keys = shownKeys(editor, id);
  const tick = tickOf(editor, id);
  return {
    kind: 'action',
    label,
    ...(keys === undefined ? {} : { keys }),
    disabled: !enabled(editor),
    ...(tick && { checked: tick.on, ...(tick.radio && { radio: true as const }) }),
    run: () => runCommand(editor, id),
  };
}

/** Text of the first keybinding of a command for menus and tooltips; undefined if there is none. */
export function shownKeys(editor: Pick<Editor, 'preferences' | 'mac'>, id: AppCommandId): string | undefined {
  const [keybinding] = keybindingsOf(editor, id);
  return keybinding === undefined ? undefined : showKeybinding(keybinding, editor.mac);
}

/** Text of the current keybinding of a command, for the tooltip of its button. */
export function useKeys(id: AppCommandId): string | undefined {
  const editor = useEditor();
  return useStore(editor.preferences, () => shownKeys(editor, id));
}
