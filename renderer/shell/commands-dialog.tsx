import { useMemo, useState } from 'react';
import { type AppCommandId, appCommand, appCommandIds, runCommand } from '../state/app-commands.ts';
import { chordsOf } from '../state/chords.ts';
import { SearchDialog } from '../ui/search-dialog.tsx';
import { showChord } from './chord.ts';
import { useEditor } from './editor-context.ts';

/** Every command by name. Those that do nothing now come last and cannot be chosen. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const isEnabled = (id: AppCommandId) => appCommand(id).enabled(editor);
  const found = useMemo(() => {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const matches = appCommandIds().filter((id) => id !== 'help.commands' && matchesAll(appCommand(id).label, words));
    const rank = (id: AppCommandId) => (appCommand(id).enabled(editor) ? 0 : 10) + distance(appCommand(id).label, words);
    return [...matches].sort((a, b) => rank(a) - rank(b));
  }, [editor, query]);
  return (
    <SearchDialog
      title="Commands"
      label="Command"
      listLabel="Commands"
      placeholder="What to do"
      none="No command is called so."
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
            {chordsOf(editor, id).map((chord) => (
              <kbd key={chord}>{showChord(chord, editor.mac)}</kbd>
            ))}
          </span>
        </>
      )}
    </SearchDialog>
  );
}

/** 0 where the label begins with what was typed, 1 where a word of it does. */
function distance(label: string, [first = '']: readonly string[]): number {
  const text = label.toLowerCase();
  return text.startsWith(first) ? 0 : text.includes(` ${first}`) ? 1 : 2;
}

function matchesAll(label: string, words: readonly string[]): boolean {
  const text = label.toLowerCase();
  return words.every((word) => text.includes(word));
}
