import { useStore } from 'zustand';
import { resetChords } from '../state/chords.ts';
import { MENUS } from '../state/menus.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { useEditor } from './editor-context.ts';
import { ShortcutRow } from './shortcut-row.tsx';
import './shortcuts-dialog.css';

const POINTER: readonly (readonly [string, string])[] = [
  ['Select several', 'Drag on the canvas, or Shift-click'],
  ['Move the canvas', 'Middle button, Space-drag, or two fingers'],
  ['Zoom', 'Wheel or pinch'],
  ['Add a node', 'Double-click, or let go of a wire over the canvas'],
  ['Put a node into a wire', 'Drag it onto the wire, or select the wire and press Tab'],
  ['Lead a wire elsewhere', 'Double-click it, and drag the point; draw more wires from the knob beside it'],
  ['Open a subgraph', 'Double-click it'],
  ['Move a frame with what is in it', 'Drag its head'],
  ['Take a wire off', 'Pull its end away'],
  ['Change a number', 'Drag it sideways; Shift for large, Alt for fine steps'],
  ['Let a number follow an expression', 'Type = and the expression: =sin(time) * 2'],
];

export function ShortcutsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const changed = useStore(editor.preferences, ({ chords }) => Object.keys(chords).length > 0);
  return (
    <Dialog title="Keyboard and pointer" onClose={onClose} wide>
      {/* First, at the top: whoever has no pointer scrolls from here. */}
      <span className="shortcuts-close">
        <IconButton icon="close" label="Close" onPress={onClose} />
      </span>
      <p>
        Press on keys to choose others for a command.{' '}
        {changed && <Button onPress={() => resetChords(editor)}>All keys as they were</Button>}
      </p>
      <div className="shortcuts">
        {MENUS.map(({ label, entries }) => (
          <section key={label}>
            <h3>{label}</h3>
            <dl>{entries.map((id) => id !== 'line' && <ShortcutRow key={id} id={id} />)}</dl>
          </section>
        ))}
      </div>
      <div className="shortcuts shortcuts-pointer">
        <section>
          <h3>Pointer and fingers</h3>
          <dl>
            {POINTER.map(([what, how]) => (
              <div key={what}>
                <dt>{what}</dt>
                <dd>{how}</dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Dialog>
  );
}
