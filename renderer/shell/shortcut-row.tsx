import { type KeyboardEvent, useState } from 'react';
import { useStore } from 'zustand';
import { chordOf } from '../key-chord.ts';
import { type AppCommandId, appCommand } from '../state/app-commands.ts';
import { bindChord, chordsOf, isRebindable, ownerOfChord } from '../state/chords.ts';
import { showChord } from './chord.ts';
import { useEditor } from './editor-context.ts';

const MODIFIERS = ['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'CapsLock'];

/** A command and its keys; pressed, it waits for others. Backspace takes them away, Escape leaves them. */
export function ShortcutRow({ id }: { readonly id: AppCommandId }) {
  const editor = useEditor();
  useStore(editor.preferences, (state) => state.chords);
  const [waiting, setWaiting] = useState(false);
  const [lost, setLost] = useState<string | null>(null);
  const label = appCommand(id).label.replace('…', '');
  const chords = chordsOf(editor, id);

  const onKeyDown = (event: KeyboardEvent) => {
    if (!waiting) return;
    event.preventDefault();
    event.stopPropagation();
    if (MODIFIERS.includes(event.key)) return;
    setWaiting(false);
    if (event.key === 'Escape') return;
    const chord = event.key === 'Backspace' ? null : chordOf(event, editor.mac);
    const loser = chord === null ? null : ownerOfChord(editor, chord, id);
    setLost(loser === null ? null : appCommand(loser).label.replace('…', ''));
    bindChord(editor, id, chord);
  };

  return (
    <div>
      <dt>
        {label}
        {lost !== null && <span className="shortcuts-lost">taken from {lost}</span>}
      </dt>
      <dd>
        {isRebindable(id) ? (
          <button
            type="button"
            className="shortcuts-keys"
            data-tip="Press for other keys"
            onClick={() => setWaiting(true)}
            onBlur={() => setWaiting(false)}
            onKeyDown={onKeyDown}
          >
            <span className="visually-hidden">Keys for {label}: </span>
            {waiting
              ? 'Press keys…'
              : chords.length === 0
                ? '–'
                : chords.map((chord) => <kbd key={chord}>{showChord(chord, editor.mac)}</kbd>)}
          </button>
        ) : (
          chords.map((chord) => <kbd key={chord}>{showChord(chord, editor.mac)}</kbd>)
        )}
      </dd>
    </div>
  );
}
