import { useStore } from 'zustand';
import { useEditor } from '../editor/editor-context.ts';
import type { AppCommandId } from './app-commands.ts';
import { shownKeys } from './command-item.ts';

/** Text of the current keybinding of a command, for the tooltip of its button. */
export function useKeys(id: AppCommandId): string | undefined {
  const editor = useEditor();
  return useStore(editor.preferences, () => shownKeys(editor, id));
}
