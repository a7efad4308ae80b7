import { useMemo, useState } from 'react';
import { type AppCommandId, appCommand, runCommand } from '../state/commands/app-commands.ts';
import { findCommands } from '../state/commands/find-commands.ts';
import { keybindingsOf } from '../state/commands/keybindings.ts';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';

/** Command palette. Disabled commands come last. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const isEnabled = (id: AppCommandId) => appCommand(id).enabled(editor);
  const found = useMemo(() => findCommands(editor, query), [editor, query]);
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
      keyOf={(id) => id}
      isEnabled={isEnabled}
      onPick={(id) => runCommand(editor, id)}
      onClose={onClose}
    >
      {(id) => (
        <>
          <span>{appCommand(id).label.replace('…', '')}</span>
          <span className="search-aside">
            {keybindingsOf(editor, id).map((keybinding) => (
              <kbd key={keybinding}>{showKeybinding(keybinding, editor.mac)}</kbd>
            ))}
          </span>
        </>
      )}
    </SearchDialog>
  );
}
