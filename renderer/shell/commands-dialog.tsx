import { useMemo, useState } from 'react';
import { type AppCommandId, appCommand, runCommand } from '../state/commands/app-commands.ts';
import { openPalette } from '../state/commands/command-actions.ts';
import { findCommands } from '../state/commands/find-commands.ts';
import { keybindingsOf } from '../state/commands/keybindings.ts';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';

/** A row of the list: a command, or the search among nodes. */
type Row = AppCommandId | typeof NODES;

const NODES = 'nodes';

/** Command palette. Disabled commands come last, then a search for nodes by the same words. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const isEnabled = (row: Row) => row === NODES || appCommand(row).enabled(editor);
  const found = useMemo((): readonly Row[] => {
    const commands = findCommands(editor, query);
    return query.trim() === '' || !appCommand('graph.add').enabled(editor) ? commands : [...commands, NODES];
  }, [editor, query]);
  return (
    <SearchDialog
      title="Commands"
      label="Command"
      listLabel="Commands"
      placeholder="Search commands"
      none="No matching command."
      query={query}
      onQuery={setQuery}
      found={found}
      keyOf={(row) => row}
      isEnabled={isEnabled}
      onPick={(row) => (row === NODES ? openPalette(editor, query) : runCommand(editor, row))}
      onClose={onClose}
    >
      {(row) =>
        row === NODES ? (
          <span>Search nodes for “{query.trim()}”</span>
        ) : (
          <>
            <span>{appCommand(row).label.replace('…', '')}</span>
            <span className="search-aside">
              {keybindingsOf(editor, row).map((keybinding) => (
                <kbd key={keybinding}>{showKeybinding(keybinding, editor.mac)}</kbd>
              ))}
            </span>
          </>
        )
      }
    </SearchDialog>
  );
}
