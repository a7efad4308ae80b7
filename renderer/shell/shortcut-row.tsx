import { type KeyboardEvent, useState } from 'react';
import { useStore } from 'zustand';
import { keybindingOf } from '../keybinding.ts';
import { type AppCommandId, appCommand } from '../state/commands/app-commands.ts';
import { isRebindable, keybindingsOf, ownerOfKeybinding, setKeybinding } from '../state/commands/keybindings.ts';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import { useEditor } from '../state/editor/editor-context.ts';

const MODIFIERS = ['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'CapsLock'];

/** A command and its keybinding. A press records a new one; Backspace removes it, Escape cancels. */
export function ShortcutRow({ id }: { readonly id: AppCommandId }) {
  const editor = useEditor();
  useStore(editor.preferences, (state) => state.keybindings);
  const [waiting, setWaiting] = useState(false);
  const [lost, setLost] = useState<string | null>(null);
  const label = appCommand(id).label.replace('…', '');
  const keybindings = keybindingsOf(editor, id);

  const onKeyDown = (event: KeyboardEvent) => {
    if (!waiting) return;
    event.preventDefault();
    event.stopPropagation();
    if (MODIFIERS.includes(event.key)) return;
    setWaiting(false);
    if (event.key === 'Escape') return;
    const keybinding = event.key === 'Backspace' ? null : keybindingOf(event, editor.mac);
    const loser = keybinding === null ? null : ownerOfKeybinding(editor, keybinding, id);
    setLost(loser === null ? null : appCommand(loser).label.replace('…', ''));
    setKeybinding(editor, id, keybinding);
  };

  return (
    <div>
      <dt>
        {label}
        {lost !== null && <span className="shortcuts-lost">removed from {lost}</span>}
      </dt>
      <dd>
        {isRebindable(id) ? (
          <button
            type="button"
            className="shortcuts-keys"
            data-tip="Press to change the keys"
            onClick={() => setWaiting(true)}
            onBlur={() => setWaiting(false)}
            onKeyDown={onKeyDown}
          >
            <span className="visually-hidden">Keys for {label}: </span>
            {waiting
              ? 'Press keys…'
              : keybindings.length === 0
                ? '–'
                : keybindings.map((keybinding) => <kbd key={keybinding}>{showKeybinding(keybinding, editor.mac)}</kbd>)}
          </button>
        ) : (
          keybindings.map((keybinding) => <kbd key={keybinding}>{showKeybinding(keybinding, editor.mac)}</kbd>)
        )}
      </dd>
    </div>
  );
}
