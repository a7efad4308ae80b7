import { useMemo, useState } from 'react';
import { searchable } from '../spellings.ts';
import type { AppCommand } from '../state/commands/app-command.ts';
import { type AppCommandId, appCommand, appCommandIds, runCommand } from '../state/commands/app-commands.ts';
import { keybindingsOf } from '../state/commands/keybindings.ts';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';

/** Command palette. Disabled commands come last. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const isEnabled = (id: AppCommandId) => appCommand(id).enabled(editor);
  const found = useMemo(() => {
    const words = searchable(query).split(/\s+/).filter(Boolean);
    const matches = appCommandIds().filter((id) => id !== 'help.commands' && matchesAll(appCommand(id), words));
    const rank = (id: AppCommandId) => (appCommand(id).enabled(editor) ? 0 : 10) + distance(appCommand(id).label, words);
    return [...matches].sort((a, b) => rank(a) - rank(b));
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

/** Rank of a match: 0 if the label begins with the first typed word, 1 if another of its words does, else 2. */
function distance(label: string, [first = '']: readonly string[]): number {
  const text = searchable(label);
  return text.startsWith(first) ? 0 : text.includes(` ${first}`) ? 1 : 2;
}

function matchesAll({ label, keywords = [] }: AppCommand, words: readonly string[]): boolean {
  const text = searchable([label, ...keywords].join('\n'));
  return words.every((word) => text.includes(word));
}
