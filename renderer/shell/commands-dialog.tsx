import { type KeyboardEvent, useId, useMemo, useRef, useState } from 'react';
import { type AppCommandId, appCommand, appCommandIds, runCommand } from '../state/app-commands.ts';
import { chordsOf } from '../state/chords.ts';
import { Dialog } from '../ui/dialog.tsx';
import { showChord } from './chord.ts';
import './commands-dialog.css';
import { useEditor } from './editor-context.ts';
import './find-dialog.css';

/** Every command by name: type, arrows, Enter. Those that do nothing now come last and cannot be chosen. */
export function CommandsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const [query, setQuery] = useState('');
  const [chosen, setChosen] = useState(0);
  const list = useRef<HTMLDivElement>(null);
  const listId = useId();
  const found = useMemo(() => {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const matches = appCommandIds().filter((id) => id !== 'help.commands' && matchesAll(appCommand(id).label, words));
    const enabled = (id: AppCommandId) => (appCommand(id).enabled(editor) ? 0 : 1);
    return [...matches].sort((a, b) => enabled(a) - enabled(b));
  }, [editor, query]);

  const run = (id: AppCommandId | undefined) => {
    if (id === undefined || !appCommand(id).enabled(editor)) return;
    onClose();
    runCommand(editor, id);
  };
  const choose = (index: number) => {
    setChosen(index);
    list.current?.children[index]?.scrollIntoView({ block: 'nearest' });
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const last = found.length - 1;
    if (event.key === 'ArrowDown') choose(chosen >= last ? 0 : chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen <= 0 ? Math.max(last, 0) : chosen - 1);
    else if (event.key === 'Enter') run(found[chosen]);
    else return;
    event.preventDefault();
  };

  return (
    <Dialog title="Commands" onClose={onClose}>
      <input
        className="field"
        data-autofocus=""
        role="combobox"
        aria-label="Command"
        aria-expanded="true"
        aria-controls={listId}
        aria-activedescendant={found[chosen] ? `${listId}-${chosen}` : undefined}
        placeholder="What to do"
        autoComplete="off"
        spellCheck={false}
        value={query}
        onChange={(event) => {
          setQuery(event.target.value);
          choose(0);
        }}
        onKeyDown={onKeyDown}
      />
      <div ref={list} id={listId} className="find-list scroll" role="listbox" aria-label="Commands">
        {found.map((id, index) => (
          // Keys are the field's: the list is only ever pointed at.
          <div
            key={id}
            id={`${listId}-${index}`}
            className="find-row command-row"
            role="option"
            aria-selected={index === chosen}
            aria-disabled={!appCommand(id).enabled(editor)}
            tabIndex={-1}
            onPointerMove={() => setChosen(index)}
            onPointerUp={() => run(id)}
          >
            <span>{appCommand(id).label.replace('…', '')}</span>
            <span className="find-graph">
              {chordsOf(editor, id).map((chord) => (
                <kbd key={chord}>{showChord(chord, editor.mac)}</kbd>
              ))}
            </span>
          </div>
        ))}
      </div>
      {found.length === 0 && <p className="find-none">No command is called so.</p>}
    </Dialog>
  );
}

function matchesAll(label: string, words: readonly string[]): boolean {
  const text = label.toLowerCase();
  return words.every((word) => text.includes(word));
}
