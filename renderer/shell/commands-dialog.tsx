import { useMemo, useState } from 'react';
import { type AppCommandId, appCommand, runCommand } from '../state/commands/app-commands.ts';
import { openPalette } from '../state/commands/command-actions.ts';
import { findCommands, findNodes } from '../state/commands/find-commands.ts';
import { keybindingsOf } from '../state/commands/keybindings.ts';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { categoryOf, type PaletteEntry } from '../state/graph/palette-search.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';

/** A row of the list: a command, a node type that the palette opens with, or the search among all nodes. */
type Row = AppCommandId | PaletteEntry | typeof NODES;

const NODES = 'nodes';

/** Command palette. Disabled commands come last, then the best nodes for the same words and a search for more. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const isEnabled = (row: Row) => row === NODES || typeof row === 'object' || appCommand(row).enabled(editor);
  const found = useMemo((): readonly Row[] => {
    const commands = findCommands(editor, query);
    return query.trim() === '' || !appCommand('graph.add').enabled(editor) ? commands : [...commands, ...findNodes(editor, query), NODES];
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
      keyOf={(row) => (typeof row === 'object' ? row.definition.type : row)}
      isEnabled={isEnabled}
      onPick={(row) => {
        if (row === NODES) openPalette(editor, query);
        else if (typeof row === 'object') openPalette(editor, row.definition.title);
        else runCommand(editor, row);
      }}
      onClose={onClose}
    >
      {(row) => {
        if (row === NODES) return <span>Search nodes for “{query.trim()}”</span>;
        if (typeof row === 'object') return <NodeRow entry={row} />;
        return (
          <>
            <span>{appCommand(row).label.replace('…', '')}</span>
            <span className="search-aside">
              {keybindingsOf(editor, row).map((keybinding) => (
                <kbd key={keybinding}>{showKeybinding(keybinding, editor.mac)}</kbd>
              ))}
            </span>
          </>
        );
      }}
    </SearchDialog>
  );
}

function NodeRow({ entry: { definition } }: { readonly entry: PaletteEntry }) {
  return (
    <>
      <span>Add “{definition.title}”</span>
      <span className="search-aside">{categoryOf(definition)}</span>
    </>
  );
}
