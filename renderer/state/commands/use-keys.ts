import { useStore } from 'zustand';
import { useEditor } from '../editor/editor-context.ts';
import type { AppCommandId } from './app-commands.ts';
import { shownKeys } from './command-item.ts';

/** The keys of a command for its button's tooltip, also when the person gives it others. */
export function useKeys(id: AppCommandId): string | undefined {
  const editor = useEditor();
  return useStore(editor.preferences, () => shownKeys(editor, id));
}
